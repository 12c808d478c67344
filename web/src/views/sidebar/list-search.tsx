import type { Page } from "../../lib/shell/pages.ts";
import type { BrowsingActions } from "../../state/browsing.ts";
import type { Browsing } from "../../state/app-state.ts";
import type { Loadable } from "../../state/loadable.ts";

export const SEARCH_ID = "list-search";
/** Characters that the service takes. */
const LONGEST = 200;

interface Props {
  browsing: Browsing;
  actions: BrowsingActions;
  studies: Loadable<Page<unknown>>;
}

/** What is looked for in both lists, by the service: it knows the entries that aren't shown, too. */
export function ListSearch({ browsing, actions, studies }: Props) {
  const { search, wanted } = browsing;
  const isFound = wanted.search !== "" && studies.status === "ready";
  return (
    <div class="list-search" role="search" aria-label="Studies and sweeps">
      <input
        id={SEARCH_ID}
        type="search"
        class="line search"
        aria-label="Search the studies by name"
        placeholder="Search by name"
        maxLength={LONGEST}
        value={search}
        onInput={(event) => actions.search(event.currentTarget.value)}
      />
      <label class="archived-switch">
        <input type="checkbox" role="switch" checked={wanted.archived} onChange={(event) => actions.showArchived(event.currentTarget.checked)} />
        Archived
      </label>
      <p class="hidden" role="status">
        {isFound && `${countOf(studies.value)} found`}
      </p>
    </div>
  );
}

function countOf({ entries, next_cursor }: Page<unknown>): string {
  const count = next_cursor === null ? String(entries.length) : `More than ${entries.length}`;
  return `${count} ${entries.length === 1 && next_cursor === null ? "study" : "studies"}`;
}
