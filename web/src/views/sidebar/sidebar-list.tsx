import type { ComponentChildren } from "preact";
import { moment } from "../../lib/format.ts";
import type { Page } from "../../lib/pages.ts";
import { formatRoute, type Route } from "../../lib/route.ts";
import { isOver, share } from "../../lib/study/point-progress.ts";
import type { EntryList } from "../../state/entry-list.ts";
import type { Loadable } from "../../state/loadable.ts";
import type { State } from "../../wire.ts";
import { Loaded } from "../shared/loaded.tsx";
import { StateBadge } from "../shared/state-badge.tsx";

interface ListProps<T> {
  title: string;
  /** Class of the list. */
  kind: string;
  list: Loadable<Page<T>>;
  actions: EntryList;
  /** What stands here while there is no entry; null where nothing then does. */
  empty: string | null;
  children: (entry: T) => ComponentChildren;
}

/** Entries of the database, newest first as the service sends them. */
export function SidebarList<T>({ title, kind, list, actions, empty, children }: ListProps<T>) {
  const many = title.toLowerCase();
  if (empty === null && list.status === "ready" && list.value.entries.length === 0) return null;
  return (
    <section>
      <h2>{title}</h2>
      <Loaded of={list} what={`the ${many}`} onRetry={() => void actions.reload()}>
        {({ entries, next_cursor }) =>
          entries.length === 0 ? (
            <p class="quiet">{empty}</p>
          ) : (
            <>
              <ul class={`entry-list ${kind}`}>{entries.map(children)}</ul>
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

interface EntryProps {
  /** What the service says of a study or a sweep. */
  of: { id: string; name: string; state: State; created: string };
  route: Route;
  isOpen: boolean;
  now_ms: number;
  /** How far it is, in words. */
  standing: string | null;
  done: number;
  total: number | null;
  list: EntryList;
}

/** One of them, with its progress while it is at work. */
export function SidebarEntry({ of, route, isOpen, now_ms, standing, done, total, list }: EntryProps) {
  function remove(): void {
    if (!window.confirm(`Remove “${of.name}” with its results? Nothing brings them back.`)) return;
    if (isOpen) location.hash = "";
    void list.remove(of.id);
  }

  return (
    <li>
      <a href={formatRoute(route)} aria-current={isOpen ? "page" : undefined}>
        <span class="entry-name">{of.name}</span>
        <span class="entry-facts">
          <StateBadge state={of.state} />
          <span>{moment(of.created, new Date(now_ms))}</span>
          {standing !== null && <span>{standing}</span>}
        </span>
        {!isOver(of.state) && (
          <progress max={1} value={share({ total, done })}>
            {done} of {total ?? "?"}
          </progress>
        )}
      </a>
      {isOver(of.state) && (
        <button type="button" class="entry-remove" aria-label={`Remove ${of.name}`} title="Remove" onClick={remove}>
          ×
        </button>
      )}
    </li>
  );
}
