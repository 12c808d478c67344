/** Figures and their legends as one drawing that needs nothing of the page: computed style is written into it, so that it looks the same elsewhere. */

const SVG = "http://www.w3.org/2000/svg";
/** What style gives a shape or a text; as attributes, since the page's policy allows no inline style. */
const STYLES = [
  "fill",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "opacity",
  "font-size",
  "font-weight",
  "font-family",
  "text-anchor",
  "paint-order",
] as const;
/** What the reader presses, and what only screen readers hear. */
const LEFT_OUT = ".as-file, .hidden, button, label, select, details";
const LEGENDS = ".key, .legend";
/** Around the drawing, and between a figure and its legend, pixels. */
const [MARGIN, GAP] = [12, 10];
/** Height of the title's line, size and width of its letters, pixels. */
const [TITLE, LETTER, LETTER_WIDTH] = [24, 14, 8];
/** Share of a letter's size from its middle to the line that it stands on. */
const MIDDLE = 0.35;

/** Something drawn, and where it is seen on the page. */
interface Piece {
  box: DOMRect;
  element: SVGElement;
}

/** Parts of the page below each other under a title: what is seen of them, each piece at its place in its part. */
export function sheetOf(title: string, parts: readonly Element[]): SVGSVGElement {
  const sheet = made("svg", {});
  let [width, top] = [title.length * LETTER_WIDTH, MARGIN + TITLE];
  for (const part of parts) {
    const pieces = [...piecesOf(part)];
    if (pieces.length === 0) continue;
    const [left, upper] = [Math.min(...pieces.map(({ box }) => box.left)), Math.min(...pieces.map(({ box }) => box.top))];
    const group = made("g", { transform: `translate(${MARGIN - left} ${top - upper})` });
    group.append(...pieces.map(({ element }) => element));
    sheet.append(group);
    width = Math.max(width, ...pieces.map(({ box }) => box.right - left));
    top += Math.max(...pieces.map(({ box }) => box.bottom)) - upper + GAP;
  }
  const [wide, high] = [Math.ceil(width) + 2 * MARGIN, Math.ceil(top) - GAP + MARGIN];
  setAll(sheet, { xmlns: SVG, width: wide, height: high, viewBox: `0 0 ${wide} ${high}` });
  sheet.prepend(...heading(title, parts[0] ?? document.body, wide, high));
  return sheet;
}

/** A figure, and the legend of its section where it has none of its own: several figures share one. */
export function withLegend(figure: Element | null): Element[] {
  const hasOwn = figure?.querySelector(LEGENDS) != null;
  const legend = hasOwn ? null : figure?.closest("section")?.querySelector(LEGENDS);
  return [figure, legend].filter((part) => part != null);
}

/** The title in letters and for screen readers, on the ground of the page: dark drawings have light lines. */
function heading(title: string, part: Element, width: number, height: number): SVGElement[] {
  const { fontFamily, color } = getComputedStyle(part);
  const told = made("title", {});
  const text = made("text", { x: MARGIN, y: MARGIN + LETTER, "font-size": LETTER, "font-weight": 600, "font-family": fontFamily, fill: color });
  [told.textContent, text.textContent] = [title, title];
  return [told, made("rect", { width, height, fill: getComputedStyle(part.closest(".panel") ?? document.body).backgroundColor }), text];
}

function* piecesOf(node: Node): Generator<Piece> {
  if (node instanceof Text) return yield* linesOf(node);
  if (!(node instanceof Element) || node.matches(LEFT_OUT) || !node.checkVisibility()) return;
  const box = node.getBoundingClientRect();
  if (node instanceof SVGSVGElement) yield { box, element: drawn(node, box) };
  else if (node instanceof HTMLCanvasElement) yield { box, element: made("image", { href: node.toDataURL("image/png"), ...placed(box) }) };
  else for (const child of node.childNodes) yield* piecesOf(child);
}

/** A drawing by itself, with the style that it has on the page. */
function drawn(svg: SVGSVGElement, box: DOMRect): SVGSVGElement {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const [from, to] = [
    [svg, ...svg.querySelectorAll("*")],
    [copy, ...copy.querySelectorAll("*")],
  ];
  from.forEach((element, k) => writeStyle(element, to[k]));
  setAll(copy, { ...placed(box), overflow: "visible" });
  return copy;
}

function writeStyle(from: Element, to: Element | undefined): void {
  const style = getComputedStyle(from);
  for (const name of STYLES) {
    const value = style.getPropertyValue(name);
    if (value !== "") to?.setAttribute(name, value);
  }
  to?.removeAttribute("class");
}

/** A text of the page, line by line as it is set. */
function linesOf(text: Text): Piece[] {
  const lines: { words: string; box: DOMRect }[] = [];
  const range = document.createRange();
  for (const { 0: word, index } of text.data.matchAll(/\S+/g)) {
    range.setStart(text, index);
    range.setEnd(text, index + word.length);
    const box = range.getBoundingClientRect();
    const line = lines.at(-1);
    if (line === undefined || box.top > line.box.top + 1) lines.push({ words: word, box });
    else Object.assign(line, { words: `${line.words} ${word}`, box: new DOMRect(line.box.x, line.box.y, box.right - line.box.x, line.box.height) });
  }
  const style = text.parentElement === null ? null : getComputedStyle(text.parentElement);
  return style === null ? [] : lines.map(({ words, box }) => ({ box, element: lineIn(words, box, style) }));
}

function lineIn(words: string, box: DOMRect, style: CSSStyleDeclaration): SVGElement {
  const size = Number.parseFloat(style.fontSize);
  const rim = Number.parseFloat(style.webkitTextStrokeWidth) > 0 ? { stroke: style.webkitTextStrokeColor, "stroke-width": style.webkitTextStrokeWidth } : {};
  const line = made("text", {
    x: box.x,
    y: box.y + box.height / 2 + MIDDLE * size,
    fill: style.color,
    "font-size": size,
    "font-weight": style.fontWeight,
    "font-family": style.fontFamily,
    "paint-order": "stroke",
    ...rim,
  });
  line.textContent = words;
  return line;
}

const placed = ({ x, y, width, height }: DOMRect): Record<string, number> => ({ x, y, width, height });

function made<K extends keyof SVGElementTagNameMap>(name: K, attributes: Record<string, string | number>): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, name);
  setAll(element, attributes);
  return element;
}

function setAll(element: Element, attributes: Record<string, string | number>): void {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}
