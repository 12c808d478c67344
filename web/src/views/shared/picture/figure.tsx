import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { fileName } from "../../../lib/shell/file-names.ts";
import { pngOf, save, svgText } from "./picture-file.ts";
import { sheetOf, withLegend } from "./picture-sheet.ts";

interface Props {
  class?: string;
  /** Name of the study, for the files. */
  study: string;
  /** Name of the figure, for the files. */
  name: string;
  children: ComponentChildren;
}

/** A figure that can be saved with its legend, under the name of its study, as SVG and PNG. */
export function Figure({ class: kind, study, name, children }: Props) {
  const figure = useRef<HTMLElement>(null);
  const sheet = (): SVGSVGElement => sheetOf(`${study}: ${name}`, withLegend(figure.current));

  function saveSvg(): void {
    save(new Blob([svgText(sheet())], { type: "image/svg+xml" }), fileName(study, name, "svg"));
  }

  async function savePng(): Promise<void> {
    save(await pngOf(sheet()), fileName(study, name, "png"));
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
