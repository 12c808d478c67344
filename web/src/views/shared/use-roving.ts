import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { movedTo } from "../../lib/shell/roving.ts";

const STOPS = 'a[href], button, input[type="checkbox"]';

/** Makes what is within the element one Tab stop, at what is current or had the focus last; arrow keys move among the rows that match. */
export function useRoving<T extends HTMLElement>(rows: string | null): RefObject<T | null> {
  const group = useRef<T>(null);
  const last = useRef<Element | null>(null);

  function lines(): HTMLElement[][] {
    const of = (element: Element): HTMLElement[] => [...element.querySelectorAll<HTMLElement>(STOPS)];
    if (group.current === null) return [];
    return rows === null ? [of(group.current)] : [...group.current.querySelectorAll(rows)].map(of);
  }

  function settle(): void {
    const all = lines().flat();
    const stop = all.find((each) => each === last.current) ?? all.find((each) => each.hasAttribute("aria-current")) ?? all[0];
    for (const each of all) each.tabIndex = each === stop ? 0 : -1;
  }

  // After every drawing: entries come and go.
  useLayoutEffect(settle);

  useLayoutEffect(() => {
    const element = group.current;
    if (element === null) return undefined;
    const focus = (event: FocusEvent): void => {
      last.current = event.target as Element;
      settle();
    };
    const press = (event: KeyboardEvent): void => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const all = lines();
      const row = all.findIndex((line) => line.some((each) => each === event.target));
      if (row < 0) return;
      const at = all[row]?.indexOf(event.target as HTMLElement) ?? 0;
      const spot = movedTo(
        { row, at },
        all.map((line) => line.length),
        event.key,
      );
      if (spot === null) return;
      event.preventDefault();
      all[spot.row]?.[spot.at]?.focus();
    };
    element.addEventListener("focusin", focus);
    element.addEventListener("keydown", press);
    return () => {
      element.removeEventListener("focusin", focus);
      element.removeEventListener("keydown", press);
    };
  }, []);

  return group;
}
