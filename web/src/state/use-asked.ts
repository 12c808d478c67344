import { useEffect, useState } from "preact/hooks";
import { answerTo, type Loadable } from "./loadable.ts";

/** What a view alone needs: asked for when the key is there, asked again when it changes, null without a key. */
export function useAsked<T>(key: string | null, ask: (key: string) => Promise<T>): Loadable<T> | null {
  const [answer, setAnswer] = useState<{ key: string; of: Loadable<T> } | null>(null);
  useEffect(() => {
    if (key === null) return undefined;
    let isWanted = true;
    void answerTo(ask(key)).then((of) => {
      if (isWanted) setAnswer({ key, of });
    });
    return () => {
      isWanted = false;
    };
  }, [key]);
  if (key === null) return null;
  return answer?.key === key ? answer.of : { status: "loading" };
}
