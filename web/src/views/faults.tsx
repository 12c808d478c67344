import { locate, type Span } from "../lib/pointer.ts";
import type { Fault, Problem } from "../types.ts";
import { ProblemText } from "./loading.tsx";

interface Props {
  text: string;
  problem: Problem | null;
  onShow: (span: Span) => void;
}

/** What the service says is wrong with the document, each fault a way to its place in the text. */
export function Faults({ text, problem, onShow }: Props) {
  if (problem === null) {
    return (
      <p class="quiet">
        The document is checked when it is sent. Every fault is listed here with its place, and nothing runs until there
        is none.
      </p>
    );
  }
  const faults = problem.errors ?? [];
  return (
    <div class="problem">
      <ProblemText problem={problem} />
      {faults.length > 0 && (
        <ul class="fault-list">
          {faults.map((fault) => (
            <li key={`${fault.pointer} ${fault.detail}`}>
              <Place text={text} fault={fault} onShow={onShow} />
              <span>{fault.detail}</span>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

function Place({ text, fault, onShow }: { text: string; fault: Fault; onShow: (span: Span) => void }) {
  const span = locate(text, fault.pointer);
  const name = fault.pointer === "" ? "whole document" : fault.pointer;
  if (span === null) return <code>{name}</code>;
  return (
    <button type="button" class="place" onClick={() => onShow(span)} title="Select it in the document">
      <code>{name}</code> line {span.line}
    </button>
  );
}
