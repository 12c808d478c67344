import type { FunctionComponent, JSX } from "preact";
import { useEffect, useState } from "preact/hooks";

/** A view in a file of its own that is loaded when it is first drawn: the first view waits for nothing that it doesn't show. */
export function later<P extends object>(what: string, load: () => Promise<FunctionComponent<P>>): (props: P) => JSX.Element {
  let loaded: FunctionComponent<P> | null = null;
  return function Later(props: P) {
    const [state, setState] = useState<"loading" | "ready" | "failed">(loaded === null ? "loading" : "ready");
    useEffect(() => {
      if (loaded !== null) return;
      load().then(
        (view) => {
          loaded = view;
          setState("ready");
        },
        () => setState("failed"),
      );
    }, []);
    const View = loaded;
    if (View !== null) return <View {...props} />;
    if (state === "failed") return <p role="alert">{what} can't be loaded. Is strainsite still running? Load the page again.</p>;
    return <p class="quiet later">Loading {what} …</p>;
  };
}
