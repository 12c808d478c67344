import type { ComponentChildren } from "preact";
import type { Page } from "../../lib/shell/pages.ts";
import type { Browsing } from "../../state/app-state.ts";
import type { EntryList } from "../../state/entry-list.ts";
import type { Loadable } from "../../state/loadable.ts";
import { Loaded } from "../shared/loaded.tsx";
import { useRoving } from "../shared/use-roving.ts";

interface ListProps<T> {
  title: string;
  /** Class of the list. */
  kind: string;
  list: Loadable<Page<T>>;
  browsing: Browsing;
  actions: EntryList;
  /** What stands here while there is no entry at all; null where nothing then does. */
  empty: string | null;
  /** Above the entries. */
  head?: ComponentChildren;
  children: (entry: T) => ComponentChildren;
}

/** Entries of the database, newest first as the service sends them. */
export function SidebarList<T extends { id: string }>({ title, kind, list, browsing, actions, empty, head, children }: ListProps<T>) {
  const many = title.toLowerCase();
  const isShown = ({ id }: T): boolean => !browsing.moved.some((moved) => moved.to === "nowhere" && moved.id === id);
  if (empty === null && list.status === "ready" && !list.value.entries.some(isShown)) return null;
  return (
    <section>
      <h2>{title}</h2>
      {head}
      <Loaded of={list} what={`the ${many}`} onRetry={() => void actions.reload()}>
        {({ entries, next_cursor }) =>
          !entries.some(isShown) ? (
            <p class="quiet">{absence(many, browsing) ?? empty}</p>
          ) : (
            <>
              <EntryRows kind={kind}>{entries.filter(isShown).map(children)}</EntryRows>
              {next_cursor !== null && (
                <button type="button" onClick={() => void actions.loadOlder()}>
                  Show older {many}
                </button>
              )}
            </>
          )
        }
      </Loaded>
    </section>
  );
}

/** Why nothing is found; null when nothing was looked for. */
function absence(many: string, { wanted }: Browsing): string | null {
  const those = wanted.archived ? `archived ${many}` : many;
  if (wanted.search !== "") return `No ${those} found for “${wanted.search}”.`;
  return wanted.archived ? `No ${those}.` : null;
}

/** One Tab stop: up and down lead from entry to entry, left and right to its buttons. */
function EntryRows({ kind, children }: { kind: string; children: ComponentChildren }) {
  const group = useRoving<HTMLUListElement>("li");
  return (
    <ul ref={group} class={`entry-list ${kind}`}>
      {children}
    </ul>
  );
}
