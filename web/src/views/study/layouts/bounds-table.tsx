import { fixed, microstrain, rankWords, significant } from "../../../lib/format.ts";
import type { RankedLayout } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** What results of earlier versions have: bounds alone, best first. */
export function BoundsTable({ layouts, csv }: { layouts: RankedLayout[]; csv: string }) {
  return (
    <>
      <ScrollTable name="Ranked layouts" csv={csv}>
        <thead>
          <tr>
            <th scope="col">Rank</th>
            <th scope="col">Spacing °</th>
            <th scope="col">Units</th>
            <th scope="col" class="words">
              Position
            </th>
            <th scope="col">Films</th>
            <th scope="col">Angle error, worst °</th>
            <th scope="col">Angle error, rms °</th>
            <th scope="col">Depth error, worst mm</th>
            <th scope="col">Weakest signal µε</th>
            <th scope="col" class="words">
              Remark
            </th>
          </tr>
        </thead>
        <tbody>
          {layouts.map((layout, k) => (
            <Row key={k} layout={layout} rank={rankWords(layout.rank, layouts)} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        Errors are Cramér–Rao bounds over all angles at which the wheel can touch down, for{" "}
        {microstrain(layouts[0]?.score.noise_strain)} µε of noise on each film. Weakest signal: the film that sees most, at the
        angle where that is least, in microstrain (µε, 10⁻⁶).
      </p>
    </>
  );
}

function Row({ layout, rank }: { layout: RankedLayout; rank: string }) {
  const { score } = layout;
  return (
    <tr>
      <td class="rank">{rank}</td>
      <td>{fixed(layout.spacing_deg, Number.isInteger(layout.spacing_deg) ? 0 : 1)}</td>
      <td>{layout.units}</td>
      <td class="words">{layout.position}</td>
      <td>{layout.films.join(", ")}</td>
      <td>{significant(score.worst_angle_error_deg)}</td>
      <td>{significant(score.rms_angle_error_deg)}</td>
      <td>{significant(score.worst_depth_error_mm)}</td>
      <td>{microstrain(score.weakest_signal)}</td>
      <td class="words">{score.reason ?? ""}</td>
    </tr>
  );
}
