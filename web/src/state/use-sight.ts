import { useEffect, useRef, useState } from "preact/hooks";
import { sightText, type Sight } from "../lib/tire/view-address.ts";

/** Rest after a change before the address has it: browsers refuse pages that rewrite theirs all the time. */
const REST_MS = 200;

/** What is seen: changed at once, in the address once it rests, and taken from there when a link is followed. */
export function useSight(inAddress: Sight, write: (sight: Sight) => void): [Sight, (change: Partial<Sight>) => void] {
  const [sight, setSight] = useState(inAddress);
  const [newest, written, timer, writer] = [useRef(inAddress), useRef(sightText(inAddress)), useRef(0), useRef(write)];
  writer.current = write;
  const text = sightText(inAddress);
  useEffect(() => {
    if (text === written.current) return;
    window.clearTimeout(timer.current);
    [written.current, newest.current] = [text, inAddress];
    setSight(inAddress);
  }, [text]);
  useEffect(() => () => window.clearTimeout(timer.current), []);

  function change(by: Partial<Sight>): void {
    newest.current = { ...newest.current, ...by };
    setSight(newest.current);
    window.clearTimeout(timer.current);
    timer.current = window.setTimeout(() => {
      written.current = sightText(newest.current);
      writer.current(newest.current);
    }, REST_MS);
  }

  return [sight, change];
}
