import { useState } from "preact/hooks";

interface Props {
  /** What is to be dropped. */
  title: string;
  isMany?: boolean;
  /** Endings of files that are offered. */
  accept?: string;
  onFiles: (files: File[]) => void;
}

/** Where files are dropped or chosen. */
export function FileDrop({ title, isMany = false, accept = ".csv,text/csv", onFiles }: Props) {
  const [isOver, setOver] = useState(false);
  const take = (list: FileList | null | undefined): void => {
    const files = [...(list ?? [])];
    if (files.length > 0) onFiles(isMany ? files : files.slice(0, 1));
  };
  return (
    <label
      class={isOver ? "file-drop file-drop-over" : "file-drop"}
      onDragOver={(event) => {
        event.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(event) => {
        event.preventDefault();
        setOver(false);
        take(event.dataTransfer?.files);
      }}
    >
      <span class="drop-title">
        {title}, or <span class="drop-choose">choose {isMany ? "them" : "it"}</span>
      </span>
      <input
        type="file"
        class="hidden"
        accept={accept}
        multiple={isMany}
        onChange={(event) => {
          take(event.currentTarget.files);
          // The same file may be chosen again, after it was changed.
          event.currentTarget.value = "";
        }}
      />
    </label>
  );
}
