/** What is in view: one study or one sweep at a time. */

import type { Part } from "./store.ts";

export interface InView<T> {
  /** Null when nothing is open. */
  get(): T | null;
  /** Changes it. An answer that comes when the reader has gone elsewhere changes nothing. */
  edit(id: string, change: (opened: T) => T): void;
  isOpen(id: string): boolean;
  open(id: string): void;
  close(): void;
  /** Asks again from the start, after a failure. */
  reopen(): void;
}

/** How what is in view is followed, from when it is opened. */
export interface Following<T> {
  begin(id: string): T;
  load(id: string): Promise<void>;
  stop(): void;
}

export function createInView<T extends { id: string }>(part: Part<T | null>, { begin, load, stop }: Following<T>): InView<T> {
  const isOpen = (id: string): boolean => part.get()?.id === id;

  function edit(id: string, change: (opened: T) => T): void {
    const opened = part.get();
    if (opened?.id === id) part.set(change(opened));
  }

  function open(id: string): void {
    if (isOpen(id)) return;
    close();
    part.set(begin(id));
    void load(id);
  }

  function close(): void {
    stop();
    part.set(null);
  }

  function reopen(): void {
    const id = part.get()?.id;
    if (id === undefined) return;
    close();
    open(id);
  }

  return { get: part.get, edit, isOpen, open, close, reopen };
}

/** Asks for what is in view again and again, while somebody looks. */
interface Polling {
  /** Once more, after a while. */
  again(id: string): void;
  end(): void;
}

export function createPolling(ask: (id: string) => Promise<void>, pause_ms: number): Polling {
  let timer: number | null = null;

  function end(): void {
    if (timer !== null) window.clearTimeout(timer);
    timer = null;
  }

  function again(id: string): void {
    end();
    timer = window.setTimeout(() => {
      if (document.visibilityState === "visible") void ask(id);
      else again(id);
    }, pause_ms);
  }

  return { again, end };
}
