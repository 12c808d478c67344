import type { Problem } from "../../api.ts";
import type { Span } from "../../lib/document/json-pointer.ts";
import { ProblemText } from "../shared/problem-box.tsx";

/** A text that faults stand in. */
export interface Place {
  span: Span;
  show: () => void;
}

interface Props {
  problem: Problem | null;
  /** Where a pointer leads; null when it leads nowhere. */
  placeOf: (pointer: string) => Place | null;
  /** What stands here while nothing is wrong. */
  idle: string;
  /** A pointer in the terms of what is written; itself when left out. */
  keyOf?: (pointer: string) => string;
}

/** What the service says is wrong with a document, each fault a way to its place in the text. */
export function Faults({ problem, placeOf, idle, keyOf = asItIs }: Props) {
  if (problem === null) return <p class="quiet">{idle}</p>;
  const faults = problem.errors ?? [];
  return (
    <div class="problem">
      <ProblemText problem={problem} />
      {faults.length > 0 && (
        <ul class="fault-list">
          {faults.map((fault) => (
            <li key={`${fault.pointer} ${fault.detail}`}>
              <PlaceOf name={fault.pointer === "" ? "whole document" : keyOf(fault.pointer)} place={placeOf(fault.pointer)} />
              <span>{fault.detail}</span>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

function asItIs(pointer: string): string {
  return pointer;
}

function PlaceOf({ name, place }: { name: string; place: Place | null }) {
  if (place === null) return <code>{name}</code>;
  return (
    <button type="button" class="place" onClick={place.show} title="Select it in the document">
      <code>{name}</code> line {place.span.line}
    </button>
  );
}

/** Selects a place in a text area and brings it into view. */
export function selectIn(area: HTMLTextAreaElement | null, span: Span): void {
  if (area === null) return;
  area.focus();
  area.setSelectionRange(span.start, span.end);
  const lines = area.value.split("\n").length;
  area.scrollTop = (area.scrollHeight * (span.line - 3)) / lines;
}
