import type { Preset } from "../../wire.ts";

interface Props {
  presets: Preset[];
  chosen: string | null;
  onChoose: (name: string) => void;
}

/** The studies that ship, to start from. */
export function PresetChoice({ presets, chosen, onChoose }: Props) {
  if (presets.length === 0) return <p class="quiet">The service ships no presets. Write a document below.</p>;
  const comment = presets.find(({ name }) => name === chosen)?.comment;
  return (
    <>
      <fieldset class="presets">
        <legend>Start from</legend>
        {presets.map((preset) => (
          <label key={preset.name} class="preset">
            <input type="radio" name="preset" value={preset.name} checked={preset.name === chosen} onChange={() => onChoose(preset.name)} />
            <span>{preset.title}</span>
          </label>
        ))}
      </fieldset>
      {comment !== undefined && (
        <details class="preset-comment">
          <summary>What this study is for</summary>
          <p class="quiet">{comment}</p>
        </details>
      )}
    </>
  );
}
