import { changedName, changesSince, differenceWords } from "../../lib/document/document-differences.ts";
import { valueAt, type SceneOfName } from "../../lib/document/document-values.ts";
import type { Origin } from "../../state/app-state.ts";

interface Props {
  document: unknown;
  origin: Origin | null;
  scenes: readonly SceneOfName[];
  onName: (name: string) => void;
}

/** The name of the study, and what differs from the document that it began with. */
export function NameField({ document, origin, scenes, onName }: Props) {
  const name = valueAt(document, "/name");
  const changes = changesSince(origin, document, scenes);
  const words = differenceWords(changes);
  const isKept = origin !== null && name === origin.name;
  return (
    <div class="name-field">
      <label for="study-name">Name</label>
      <input
        id="study-name"
        class="line"
        autocomplete="off"
        value={typeof name === "string" ? name : ""}
        aria-describedby="study-differs"
        onInput={(event) => onName(event.currentTarget.value)}
      />
      <p id="study-differs" class="quiet">
        {words === null || origin === null
          ? `Nothing differs from ${origin === null ? "the start" : `“${origin.name}”`} yet.`
          : `Differs from “${origin.name}”: ${words}.`}
        {words !== null && isKept && ` Will be called “${changedName(origin.name, changes)}”.`}
      </p>
    </div>
  );
}
