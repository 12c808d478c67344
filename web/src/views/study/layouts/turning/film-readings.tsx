import { fixed, microstrain, significant } from "../../../../lib/format.ts";
import { filmWord } from "../../../../lib/layouts/layout-words.ts";
import type { Reading } from "../../../../lib/layouts/wheel-readings.ts";
import { ScrollTable } from "../../../shared/scroll-table.tsx";

interface Props {
  readings: readonly Reading[];
  noise: number;
  /** `strain`, or `V`. */
  unit: string;
}

/** What each film reads, beside its noise: those that read most come first. */
export function FilmReadings({ readings, noise, unit }: Props) {
  const isStrain = unit === "strain";
  const shown = (value: number): string => (isStrain ? microstrain(value) : significant(value));
  const name = isStrain ? "µε" : unit;
  const rows = [...readings].sort((a, b) => Math.abs(b.signal) - Math.abs(a.signal));
  const heard = readings.filter(({ signal }) => Math.abs(signal) > noise).length;
  return (
    <>
      <p>
        {heard} of {readings.length} films read more than their noise.
      </p>
      <ScrollTable
        name="Readings of the films"
        kind="readings"
        isTall
        columns={["From the contact", "Film", `Reads ${name}`, `Noise ${name}`, "Times its noise"]}
      >
        <tbody>
          {rows.map(({ film, apart_deg, signal }) => (
            <tr key={`${film.theta_deg} ${film.section_deg} ${film.angle_deg}`} class={Math.abs(signal) > noise ? undefined : "below-noise"}>
              <th scope="row">{fixed(apart_deg, Number.isInteger(apart_deg) ? 0 : 1)}°</th>
              <td>{filmWord(String(film.angle_deg))}</td>
              <td>{shown(signal)}</td>
              <td>± {shown(noise)}</td>
              <td>{fixed(Math.abs(signal) / noise, 1)}</td>
            </tr>
          ))}
        </tbody>
      </ScrollTable>
    </>
  );
}
