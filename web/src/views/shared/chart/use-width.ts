import { useLayoutEffect, useState } from "preact/hooks";

/** The width of an element, pixels; a guess before it is drawn. */
export function useWidth(holder: { current: HTMLElement | null }, guess: number): number {
  const [width, setWidth] = useState(guess);
  useLayoutEffect(() => {
    const element = holder.current;
    if (element === null) return undefined;
    const measure = (): void => setWidth(element.clientWidth);
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return width;
}
