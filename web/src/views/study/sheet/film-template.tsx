import { useLayoutEffect, useRef } from "preact/hooks";
import { sheetPieces } from "../../../lib/study/answer/sheet-pieces.ts";

/** The service's template in pieces that paper holds. */
export function FilmTemplate({ svg }: { svg: string }) {
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => place.current?.replaceChildren(...piecesOf(svg)), [svg]);
  return <div ref={place} class="scroll" tabIndex={0} role="group" aria-label="Template, scrolled sideways" />;
}

/** A drawing for each piece, as wide as the template, in a tree of its own: the page's style for drawings would change its letters. A strip begins with its outline; what comes before the first is drawn with that one. */
function piecesOf(svg: string): HTMLElement[] {
  const { documentElement: whole } = new DOMParser().parseFromString(svg, "image/svg+xml");
  const parts: Element[][] = [[]];
  for (const node of whole.children) {
    if (node.localName === "clipPath") parts.push([]);
    parts.at(-1)?.push(node);
  }
  const [head = [], ...strips] = parts;
  const number = (element: Element, name: string): number => Number.parseFloat(element.getAttribute(name) ?? "");
  const outlines = [...whole.querySelectorAll("clipPath > rect")].map((rect) => ({ y_mm: number(rect, "y"), height_mm: number(rect, "height") }));
  return sheetPieces(number(whole, "height"), outlines).map(({ strip, y_mm, height_mm }) => {
    const piece = whole.cloneNode(false) as SVGSVGElement;
    piece.setAttribute("viewBox", `0 ${y_mm} ${number(whole, "width")} ${height_mm}`);
    piece.setAttribute("height", `${height_mm}mm`);
    piece.setAttribute("display", "block");
    piece.setAttribute("role", "img");
    piece.setAttribute("aria-label", `Strip ${strip + 1} of ${strips.length}`);
    piece.append(...[...(strip === 0 ? head : []), ...(strips[strip] ?? [])].map((node) => node.cloneNode(true)));
    const sheet = document.createElement("div");
    sheet.attachShadow({ mode: "open" }).append(piece);
    return sheet;
  });
}
