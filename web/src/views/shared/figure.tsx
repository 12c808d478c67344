import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { fileName } from "../../lib/shell/file-names.ts";
import { pngOf, save, svgText } from "./picture-file.ts";

interface Props {
  class?: string;
  /** Name of the study, for the files. */
  study: string;
  /** Name of the figure, for the files. */
  name: string;
  children: ComponentChildren;
}

/** A figure whose first drawing, over its canvas if it has one, can be saved as SVG and PNG. */
export function Figure({ class: kind, study, name, children }: Props) {
  const figure = useRef<HTMLElement>(null);
  const drawing = (): SVGSVGElement | null => figure.current?.querySelector("svg") ?? null;
  const below = (): HTMLCanvasElement | null => figure.current?.querySelector("canvas") ?? null;

  function saveSvg(): void {
    const svg = drawing();
    if (svg !== null) save(new Blob([svgText(svg, below())], { type: "image/svg+xml" }), fileName(study, name, "svg"));
  }

  async function savePng(): Promise<void> {
    const svg = drawing();
    if (svg !== null) save(await pngOf(svg, below()), fileName(study, name, "png"));
  }

  return (
    <figure ref={figure} class={kind}>
      {children}
      <p class="as-file">
        <button type="button" aria-label={`Save ${name} as SVG`} onClick={saveSvg}>
          SVG
        </button>
        <button type="button" aria-label={`Save ${name} as PNG`} onClick={() => void savePng()}>
          PNG
        </button>
      </p>
    </figure>
  );
}
