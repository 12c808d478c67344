import { MISSING, rankWords } from "../../../lib/format.ts";
import { layoutWords, short } from "../../../lib/layouts/layout-words.ts";
import type { LayoutLoad, RankedLayout } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** Layouts that are listed: the best ones. */
const SHOWN = 20;

/** What is known with forces along and across the wheel unknown, too. */
export function ShearTable({ layouts, loads }: { layouts: RankedLayout[]; loads: LayoutLoad[] }) {
  const rows = layouts.filter((layout) => layout.score.shear != null).slice(0, SHOWN);
  const load = loads.find((each) => each.shear != null);
  if (rows.length === 0 || load?.shear == null) return null;
  const [along, across] = load.shear.slopes_n_per_mm;
  const telling = layouts.find((layout) => layout.score.shear != null && layout.score.shear.reason == null);
  return (
    <>
      <h3>With forces along and across the wheel unknown</h3>
      <p>
        {telling === undefined ? (
          "No layout tells them at its worst load."
        ) : (
          <>
            The best layout that tells them at its worst load is <strong>{layoutWords(telling)}</strong>, at rank {telling.rank}.
          </>
        )}
      </p>
      <ScrollTable name="Layouts with shear unknown">
        <thead>
          <tr>
            <th scope="col">Rank</th>
            <th scope="col" class="words">
              Layout
            </th>
            <th scope="col">Angle, bound °</th>
            <th scope="col">Force along N</th>
            <th scope="col">Force across N</th>
            <th scope="col">Force up N</th>
            <th scope="col" class="words">
              What can't be told
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((layout, k) => (
            <Row key={k} layout={layout} rank={rankWords(layout.rank, layouts)} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        Cramér–Rao bounds at the worst contact angle and the layout's worst load, about a contact that isn't dragged. Dragged a little, the ground pulls{" "}
        {short(along)} N/mm along the wheel and {short(across)} N/mm across it at {short(load.load_n)} N, and slides from {short(load.shear.sliding_n)} N on.
      </p>
    </>
  );
}

function Row({ layout, rank }: { layout: RankedLayout; rank: string }) {
  const { shear } = layout.score;
  const forces = shear?.worst_force_error_n ?? [null, null, null];
  const errors = shear?.error?.worst_force_error_n ?? [null, null, null];
  return (
    <tr>
      <td class="rank">{rank}</td>
      <th scope="row" class="words layout-name">
        {layoutWords(layout)}
      </th>
      <td>{short(shear?.worst_angle_error_deg)}</td>
      {forces.map((force, axis) => (
        <td key={axis}>
          {force == null ? MISSING : short(force)} {errors[axis] != null && <span class="error">± {short(errors[axis], 2)}</span>}
        </td>
      ))}
      <td class="words">{shear?.reason ?? ""}</td>
    </tr>
  );
}
