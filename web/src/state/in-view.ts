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
