import { loadWords, short } from "../../../../lib/layouts/layout-words.ts";
import { layoutBounds, type Bounds, type LoadBounds, type ReadyFields } from "../../../../lib/layouts/moving/layout-bounds.ts";
import { comparedWords } from "../../../../lib/layouts/moving/compared-words.ts";
import type { FilmPlace } from "../../../../wire.ts";
import { ScrollTable, words } from "../../../shared/scroll-table.tsx";
import { useMemo } from "preact/hooks";

interface Props {
  ready: ReadyFields;
  films: FilmPlace[];
  begun: FilmPlace[];
}

/** The bounds of both, load by load: computed here, as the service does it. */
export function MovedBounds({ ready, films, begun }: Props) {
  const before = useMemo(() => layoutBounds(ready, begun), [ready, begun]);
  const now = useMemo(() => layoutBounds(ready, films), [ready, films]);
  if (films.length === 0) return <p role="status">No film is left. Add one, or undo.</p>;
  if (now === null) return <p class="flag">A film is of a kind that this study has nothing of. Undo, or go back to the layout.</p>;
  return (
    <>
      <p class="headline" role="status">
        {films.length} films. {comparedWords(worst(now), before === null ? null : worst(before))}
      </p>
      <ScrollTable name="Bounds of the moved films" kind="bounds" columns={[words("Load"), "Angle, worst °", "before °", "Angle, rms °", "Depth, worst mm"]}>
        <tbody>
          {now.map((found, k) => (
            <Row key={k} now={found} before={before?.[k]} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        Cramér–Rao bounds with the depth unknown, over all angles at which the wheel touches down: no estimate is better. Forces along and across the wheel are
        left out here.
      </p>
    </>
  );
}

function Row({ now, before }: { now: LoadBounds; before: LoadBounds | undefined }) {
  const bounds = boundsOf(now);
  return (
    <tr>
      <th scope="row" class="words">
        {loadWords({ depth_mm: now.load.depth_mm, load_n: now.load.load_n ?? null })}
      </th>
      {bounds === null ? <td>blind at {"blind_deg" in now ? now.blind_deg : 0}°</td> : <td>{short(bounds.worst_angle_deg)}</td>}
      <td>{short(before === undefined ? null : boundsOf(before)?.worst_angle_deg)}</td>
      <td>{short(bounds?.rms_angle_deg)}</td>
      <td>{short(bounds?.worst_depth_mm)}</td>
    </tr>
  );
}

const boundsOf = (found: LoadBounds): Bounds | null => ("bounds" in found ? found.bounds : null);

/** The largest of the loads; infinite where one can't be told. */
function worst(all: readonly LoadBounds[]): number {
  return Math.max(...all.map((found) => boundsOf(found)?.worst_angle_deg ?? Infinity));
}
