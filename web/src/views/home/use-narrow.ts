import { useEffect, useState } from "preact/hooks";

/** Where the form has one column, see study-form.css. */
const NARROW = "(max-width: 900px)";

/** Whether the window is so narrow. */
export function useNarrow(): boolean {
  const [isNarrow, setNarrow] = useState(() => window.matchMedia(NARROW).matches);
  useEffect(() => {
    const query = window.matchMedia(NARROW);
    const see = (): void => setNarrow(query.matches);
    query.addEventListener("change", see);
    return () => query.removeEventListener("change", see);
  }, []);
  return isNarrow;
}
