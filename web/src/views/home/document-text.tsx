import type { StudyDraft } from "../../state/app-state.ts";

export interface TextProps {
  draft: StudyDraft;
  area: { current: HTMLTextAreaElement | null };
  isWrong: boolean;
}

/** The box that a document is typed in. */
export function DocumentText({
  language,
  value,
  area,
  isWrong,
  onEdit,
}: Omit<TextProps, "draft"> & { language: string; value: string; onEdit: (text: string) => void }) {
  return (
    <>
      <label class="document-label" for="document">
        Study document ({language})
      </label>
      <textarea
        id="document"
        ref={area}
        spellcheck={false}
        autocomplete="off"
        rows={28}
        value={value}
        aria-describedby="document-faults"
        aria-invalid={isWrong}
        onInput={(event) => onEdit(event.currentTarget.value)}
      />
    </>
  );
}
