import type { Route } from "../../lib/route.ts";
import type { Moved } from "../../state/app-state.ts";
import type { EntryList } from "../../state/entry-list.ts";
import type { State } from "../../wire.ts";

export interface EntryProps {
  /** What the service says of a study or a sweep. */
  of: { id: string; name: string; state: State; created: string; archived?: string | null };
  kind: Moved["kind"];
  route: Route;
  isOpen: boolean;
  now_ms: number;
  /** How far it is, in words. */
  standing: string | null;
  done: number;
  total: number | null;
  list: EntryList;
  onMoved: (moved: Moved) => void;
  /** What tells it from others of its name. */
  note?: string | null;
  /** Of an entry that can be compared. */
  compared?: { isTicked: boolean; onTick: (on: boolean) => void } | null;
}
