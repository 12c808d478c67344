import { lineAt, numberAt, titleAt, type Edges, type Length, type Lines, type Side, type TitlePlace } from "../../../lib/chart/axis-places.ts";
import type { Ticks } from "../../../lib/chart/scales.ts";

interface Props<T> extends Omit<Ticks<T, Length>, "text"> {
  side: Side;
  frame: Edges;
  /** Null where another axis says it. */
  text: ((value: T) => string) | null;
  lines?: Lines | "none";
  class?: string;
  /** A class for single values. */
  tone?: (value: T) => string | undefined;
  title?: string;
  titlePlace?: TitlePlace;
}

/** An axis: a line and a text for each value, and its title. */
export function Axis<T extends string | number>(props: Props<T>) {
  const { side, frame, values, at, text, lines = "through", class: kind, tone, title, titlePlace = "middle" } = props;
  return (
    <g class={kind === undefined ? "axis" : `axis ${kind}`}>
      {values.map((value) => (
        <g key={value} class={tone?.(value)}>
          {lines !== "none" && <line {...lineAt(side, frame, at(value), lines)} />}
          {text !== null && <text {...numberAt(side, frame, at(value), lines)}>{text(value)}</text>}
        </g>
      ))}
      {title !== undefined && <text {...titleAt(side, frame, titlePlace)}>{title}</text>}
    </g>
  );
}
