import type { ComponentChildren } from "preact";

interface Props {
  text: string;
  /** What the mark needs; it is drawn 12 pixels high. */
  box?: string;
  /** The mark, as the chart draws it. */
  children: ComponentChildren;
}

/** What a mark of a chart means. */
export function KeyEntry({ text, box = "0 0 12 12", children }: Props) {
  return (
    <span>
      <svg viewBox={box} aria-hidden="true">
        {children}
      </svg>
      {text}
    </span>
  );
}

/** What a line of this class means. */
export function KeyLine({ class: kind, text, length = 24 }: { class: string; text: string; length?: number }) {
  return (
    <KeyEntry text={text} box={`0 0 ${length} 12`}>
      <g class={kind}>
        <path d={`M0 6H${length}`} />
      </g>
    </KeyEntry>
  );
}
