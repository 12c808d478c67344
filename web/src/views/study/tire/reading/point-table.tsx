import { directionName } from "../../../../lib/direction.ts";
import { fixed, microstrain, percent } from "../../../../lib/format.ts";
import { statusName } from "../../../../lib/study/output-words.ts";
import type { DirectionReading, PointReading } from "../../../../lib/tire/map/point-reading.ts";
import { Readout } from "./readout.tsx";

interface Props {
  reading: PointReading | null;
  isPinned: boolean;
  unit: "mm" | "°";
  inputs: readonly string[];
  /** Where the strain is read, as `at the means`. */
  where: string;
  onRelease: () => void;
}

/** Everything at one place. Without a place the table stands empty, so that nothing moves when the pointer comes. */
export function PointTable({ reading, isPinned, unit, inputs, where, onRelease }: Props) {
  const [x, y] = ["x", "y"].map((direction) => reading?.directions.find((each) => each.direction === direction) ?? null);
  return (
    <section class="reading" aria-labelledby="reading-title">
      <h3 id="reading-title">At one place</h3>
      <Readout
        point={reading}
        isPinned={reading !== null && isPinned}
        onRelease={onRelease}
        hint="Point at tire or map to read it there; click, or press Enter, to pin the place."
      >
        {unit === "mm" && (
          <span>
            {fixed(reading?.along, 1)} mm along, {fixed(reading?.across, 1)} mm across
          </span>
        )}
      </Readout>
      <table class="point-table" aria-label="Reading at the place">
        <thead>
          <tr>
            <td></td>
            <th scope="col">{directionName("x")}</th>
            <th scope="col">{directionName("y")}</th>
          </tr>
        </thead>
        <tbody>
          <Row name={`strain ${where}, µε`} cells={[x, y].map((of) => microstrain(of?.strain))} />
          <Row name="standard deviation, µε" cells={[x, y].map((of) => microstrain(of?.deviation))} />
          {inputs.map((name, input) => (
            <Row key={name} name={`index of ${name}, %`} cells={[x, y].map((of) => indexWords(of ?? null, input))} />
          ))}
          <Row name="status" cells={[x, y].map((of) => (of == null ? "—" : statusName(of.status)))} />
        </tbody>
      </table>
    </section>
  );
}

function Row({ name, cells }: { name: string; cells: readonly string[] }) {
  return (
    <tr>
      <th scope="row">{name}</th>
      {cells.map((cell, index) => (
        <td key={index}>{cell}</td>
      ))}
    </tr>
  );
}

function indexWords(of: DirectionReading | null, input: number): string {
  const reading = of?.indices[input];
  if (reading === undefined || reading.index === null) return "—";
  return `${percent(reading.index)} ± ${reading.error === null ? "?" : percent(reading.error)}`;
}
