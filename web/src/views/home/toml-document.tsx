import { useMemo } from "preact/hooks";
import { readToml, tomlOf, type TypedToml } from "../../lib/document/toml/toml-text.ts";
import { DocumentText, type TextProps } from "./document-text.tsx";

/** The document as TOML. In a file of its own, for its reader is loaded only here. */
export function TomlDocument({ draft, area, isWrong, onEdit }: TextProps & { onEdit: (toml: TypedToml) => void }) {
  const shown = useMemo(() => tomlOf(draft.text, draft.toml), [draft.text, draft.toml]);
  return (
    <>
      <DocumentText language="TOML" value={shown} area={area} isWrong={isWrong} onEdit={(text) => onEdit(readToml(text))} />
      <p class="quiet">Comments stay while it is written here. A name, an accuracy or a field set elsewhere writes it anew.</p>
    </>
  );
}
