/** The grid of a sweep as it is written: `path = value, value`, one path a line. */

import type { Fault } from "../../wire.ts";
import { pointerKeys, type Span } from "../document/json-pointer.ts";

interface Value {
  value: unknown;
  start: number;
  end: number;
}

interface Line {
  path: string;
  values: Value[];
  span: Span;
}

export interface Grid {
  /** Lists of values by path. */
  document: Record<string, unknown[]>;
  lines: Line[];
  /** Of lines that can't be read, at pointers like `#3` for the third line. */
  faults: Fault[];
}

/** Reads all lines, empty ones and those that begin with # left out. */
export function readGrid(text: string): Grid {
  const grid: Grid = { document: Object.create(null) as Grid["document"], lines: [], faults: [] };
  let start = 0;
  text.split("\n").forEach((content, index) => {
    const span = { start, end: start + content.length, line: index + 1 };
    start = span.end + 1;
    if (content.trim() !== "" && !content.trimStart().startsWith("#")) readLine(grid, content, span);
  });
  if (grid.lines.length === 0 && grid.faults.length === 0) {
    grid.faults.push({ pointer: "#1", detail: "No value is varied yet: geometry.wall_mm = 2.5, 3, 3.5 makes three designs." });
  }
  return grid;
}

/** Adds a line, or what is wrong with it. */
function readLine(grid: Grid, content: string, span: Span): void {
  const fault = (detail: string): number => grid.faults.push({ pointer: `#${span.line}`, detail });
  const equals = content.indexOf("=");
  const path = content.slice(0, equals).trim();
  const values = split(content, equals + 1, span.start);
  if (equals < 0 || path === "") fault("A line is a path, = and values with commas between them: geometry.wall_mm = 2.5, 3");
  else if (path in grid.document) fault(`${path} stands in an earlier line already.`);
  else if (values.some(({ start, end }) => start === end)) fault("A value is missing beside a comma, or after the =.");
  else {
    grid.document[path] = values.map(({ value }) => value);
    grid.lines.push({ path, values, span });
  }
}

/** At commas outside of brackets and quotes, as on the command line. */
function split(content: string, from: number, offset: number): Value[] {
  const values: Value[] = [];
  let [depth, quoted, begin] = [0, false, from];
  for (let at = from; at <= content.length; at += 1) {
    const character = content[at] ?? ",";
    if (character === '"') quoted = !quoted;
    else if ("[{".includes(character) && !quoted) depth += 1;
    else if ("]}".includes(character) && !quoted) depth -= 1;
    if (at === content.length || (character === "," && depth <= 0 && !quoted)) {
      values.push(valueIn(content, begin, at, offset));
      begin = at + 1;
    }
  }
  return values;
}

function valueIn(content: string, begin: number, end: number, offset: number): Value {
  const part = content.slice(begin, end);
  const text = part.trim();
  const start = offset + begin + part.length - part.trimStart().length;
  return { value: jsonOrWord(text), start, end: start + text.length };
}

/** What isn't JSON is a word, and so is a number beyond all numbers: the service then says what it is. */
function jsonOrWord(text: string): unknown {
  try {
    const value = JSON.parse(text) as unknown;
    return typeof value === "number" && !Number.isFinite(value) ? text : value;
  } catch {
    return text;
  }
}

/** Where a fault of the grid stands: its value, its line, or nowhere. */
export function locateInGrid(text: string, pointer: string): Span | null {
  const { lines } = readGrid(text);
  if (pointer.startsWith("#")) return lineAt(text, Number(pointer.slice(1)));
  const [root, path, index] = pointerKeys(pointer);
  const line = root === "grid" ? lines.find((entry) => entry.path === path) : undefined;
  if (line === undefined) return null;
  const value = index === undefined ? undefined : line.values[Number(index)];
  return value === undefined ? line.span : { start: value.start, end: value.end, line: line.span.line };
}

function lineAt(text: string, line: number): Span | null {
  const contents = text.split("\n");
  const content = contents[line - 1];
  if (content === undefined) return null;
  const start = contents.slice(0, line - 1).reduce((sum, before) => sum + before.length + 1, 0);
  return { start, end: start + content.length, line };
}

/** How many designs the lines make: every combination. */
export function designCount(grid: Grid): number {
  return grid.lines.reduce((product, line) => product * line.values.length, grid.lines.length === 0 ? 0 : 1);
}
