import { useEffect, useState } from "preact/hooks";

/** What a box holds as it is typed; null before, once it is left, and when the address leads to another draft. */
export function useTyped(): [string | null, (typed: string | null) => void] {
  const [typed, setTyped] = useState<string | null>(null);
  const isTyped = typed !== null;
  useEffect(() => {
    if (!isTyped) return undefined;
    const forget = (): void => setTyped(null);
    window.addEventListener("hashchange", forget);
    return () => window.removeEventListener("hashchange", forget);
  }, [isTyped]);
  return [typed, setTyped];
}
