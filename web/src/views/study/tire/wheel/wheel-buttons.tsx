import type { ViewName } from "../../../../lib/tire/eye/orbit.ts";
import { fixed } from "../../../../lib/format.ts";
import { MOST_FACTOR } from "../../../../lib/tire/view-address.ts";

export interface WheelActions {
  turn: (azimuth_deg: number, elevation_deg: number) => void;
  /** By a factor. */
  zoom: (nearby: number) => void;
  goTo: (view: ViewName) => void;
  cut: () => void;
  /** Absent where several pictures have these buttons together. */
  save?: () => void;
}

interface Props {
  actions: WheelActions;
  factor: number;
  onFactor: (factor: number) => void;
  isCut: boolean;
  hasGround: boolean;
}

const VIEWS: readonly { name: ViewName; label: string; key: string }[] = [
  { name: "front", label: "Front", key: "1" },
  { name: "side", label: "Side", key: "2" },
  { name: "top", label: "Top", key: "3" },
  { name: "section", label: "Section", key: "4" },
  { name: "start", label: "Reset", key: "r" },
];
const TURNS: readonly { label: string; words: string; by: [number, number] }[] = [
  { label: "←", words: "Turn left", by: [-8, 0] },
  { label: "→", words: "Turn right", by: [8, 0] },
  { label: "↑", words: "Turn up", by: [0, 8] },
  { label: "↓", words: "Turn down", by: [0, -8] },
];

/** What the keys do, for the pointer. */
export function WheelButtons({ actions, factor, onFactor, isCut, hasGround }: Props) {
  return (
    <div class="wheel-buttons">
      <div role="group" aria-label="Views">
        {VIEWS.map(({ name, label, key }) => (
          <button key={name} type="button" title={`Key ${key}`} onClick={() => actions.goTo(name)}>
            {label}
          </button>
        ))}
        <button type="button" title="Key c" aria-pressed={isCut} onClick={actions.cut}>
          Cut open
        </button>
      </div>
      <div role="group" aria-label="Turn and zoom">
        {TURNS.map(({ label, words, by }) => (
          <button key={words} type="button" aria-label={words} onClick={() => actions.turn(...by)}>
            {label}
          </button>
        ))}
        <button type="button" aria-label="Nearer" onClick={() => actions.zoom(1.2)}>
          +
        </button>
        <button type="button" aria-label="Farther" onClick={() => actions.zoom(1 / 1.2)}>
          −
        </button>
        {actions.save !== undefined && (
          <button type="button" title="Save this picture as a PNG file" onClick={actions.save}>
            PNG
          </button>
        )}
      </div>
      <label class="deformation">
        <span>deformation ×{fixed(factor, factor % 1 === 0 ? 0 : 1)}</span>
        <input type="range" min={0} max={MOST_FACTOR} step={0.1} value={factor} onInput={(event) => onFactor(event.currentTarget.valueAsNumber)} />
        {hasGround && factor !== 1 && <span class="quiet">the ground is drawn at ×1 only</span>}
      </label>
    </div>
  );
}
