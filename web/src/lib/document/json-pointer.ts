/** Finds the text of the value that a JSON pointer (RFC 6901) names, so that a fault can be shown where it is. */

export interface Span {
  start: number;
  end: number;
  /** Counted from one. */
  line: number;
}

/** The keys of a pointer: `/inputs/0/name` -> inputs, 0, name. */
export function pointerKeys(pointer: string): string[] {
  if (pointer === "" || pointer === "/") return [];
  return pointer
    .replace(/^#?\//, "")
    .split("/")
    .map((key) => key.replaceAll("~1", "/").replaceAll("~0", "~"));
}

/** A pointer as TOML's keys: `/inputs/0/name` -> inputs[0].name. */
export function tomlKey(pointer: string): string {
  const part = (key: string): string => (/^\d+$/.test(key) ? `[${key}]` : `.${/^[\w-]+$/.test(key) ? key : JSON.stringify(key)}`);
  return pointerKeys(pointer).map(part).join("").replace(/^\./, "");
}

/** Where the value lies; the nearest enclosing value that exists when it doesn't; null when the text is not JSON. */
export function locate(text: string, pointer: string): Span | null {
  try {
    JSON.parse(text);
  } catch {
    return null;
  }
  const scanner = new Scanner(text);
  let span = scanner.valueAt(0);
  for (const key of pointerKeys(pointer)) {
    const child = scanner.member(span.start, key);
    if (child === null) break;
    span = child;
  }
  return { ...span, line: text.slice(0, span.start).split("\n").length };
}

interface Range {
  start: number;
  end: number;
}

/** Walks text that is known to be JSON. */
class Scanner {
  private readonly text: string;

  constructor(text: string) {
    this.text = text;
  }

  valueAt(from: number): Range {
    const start = this.skipSpace(from);
    return { start, end: this.endOf(start) };
  }

  /** The member of the object or array that starts at `start`. */
  member(start: number, key: string): Range | null {
    const isArray = this.text[start] === "[";
    if (!isArray && this.text[start] !== "{") return null;
    let at = this.skipSpace(start + 1);
    for (let index = 0; at < this.text.length && !"]}".includes(this.text[at] as string); index += 1) {
      let name = String(index);
      if (!isArray) {
        const end = this.endOf(at);
        name = JSON.parse(this.text.slice(at, end)) as string;
        at = this.skipSpace(end) + 1;
      }
      const value = this.valueAt(at);
      if (name === key) return value;
      at = this.skipSpace(value.end);
      if (this.text[at] === ",") at = this.skipSpace(at + 1);
    }
    return null;
  }

  private skipSpace(from: number): number {
    let at = from;
    while (at < this.text.length && " \t\r\n".includes(this.text[at] as string)) at += 1;
    return at;
  }

  private endOf(start: number): number {
    const first = this.text[start];
    if (first === '"') return this.endOfString(start);
    if (first !== "{" && first !== "[") return this.endOfWord(start);
    let depth = 0;
    for (let at = start; at < this.text.length; at += 1) {
      const character = this.text[at] as string;
      if (character === '"') at = this.endOfString(at) - 1;
      else if ("{[".includes(character)) depth += 1;
      else if ("}]".includes(character)) depth -= 1;
      if (depth === 0) return at + 1;
    }
    return this.text.length;
  }

  private endOfString(start: number): number {
    let at = start + 1;
    while (at < this.text.length && this.text[at] !== '"') at += this.text[at] === "\\" ? 2 : 1;
    return at + 1;
  }

  private endOfWord(start: number): number {
    let at = start;
    while (at < this.text.length && !",]} \t\r\n".includes(this.text[at] as string)) at += 1;
    return at;
  }
}
