import type { Fault } from "../../../wire.ts";

/** What every part of the form is given. */
export interface FormProps {
  /** The document as written. */
  document: unknown;
  /** The same with its scene in full. */
  full: unknown;
  faults: readonly Fault[];
  /** Puts a value into the document as written; undefined takes it away. */
  write: (pointer: string, value: unknown) => void;
  /** Puts a whole document in its place. */
  replace: (document: unknown) => void;
}

/** The faults of a field, those of its parts among them. */
export function faultsAt(faults: readonly Fault[], pointer: string): Fault[] {
  return faults.filter((fault) => fault.pointer === pointer || fault.pointer.startsWith(`${pointer}/`));
}
