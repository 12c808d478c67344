import { heading, view } from "../../../lib/study/figures/columns.ts";
import { fixed } from "../../../lib/format.ts";
import { AXIS_WORDS, bestKnown, floorOf, type KnownForce, knownForces, rangeByDrift, untoldAxes } from "../../../lib/layouts/known-forces.ts";
import { layoutWords } from "../../../lib/layouts/layout-words.ts";
import { DRIFTS_COLUMNS, ELSEWHERE_COLUMNS, FORCES_COLUMNS, type ForceFindings, type ForcePrice, type RankedLayout, type TableReport } from "../../../wire.ts";
import { FigureCells } from "../figure-cells.tsx";
import { GluedNote } from "./glued-note.tsx";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

/** How well forces are known by layouts' films, learnt from a virtual rig's runs. */
export function KnownForcesPanel({ layouts, findings }: { layouts: RankedLayout[]; findings: ForceFindings }) {
  const known = knownForces(layouts);
  const untold = untoldAxes(layouts);
  return (
    <section class="panel" aria-labelledby="known-forces-title">
      <h2 id="known-forces-title">Forces</h2>
      {[...new Set(known.map(({ force }) => force.axis))].map((axis) => (
        <Best key={axis} best={bestKnown(known, axis)} />
      ))}
      {untold.length > 0 && (
        <p>No layout's films tell more of {untold.map((axis) => `${name(axis)} (${AXIS_WORDS[axis] ?? axis})`).join(" and ")} than the training mean does.</p>
      )}
      <Prices known={known} prices={findings.price ?? []} />
      {known.length > 0 && <KnownTable known={known} />}
      <Drifts known={known} />
      <Alike known={known} />
      <OtherTires known={known} />
      {(findings.reasons ?? []).map((reason) => (
        <p key={reason} class="flag">
          {reason}
        </p>
      ))}
      {findings.table != null && <TableNote table={findings.table} />}
      {findings.table?.films != null && <GluedNote films={findings.table.films} />}
      {(findings.assumed ?? []).length > 0 && (
        <details>
          <summary>What is assumed of the rig</summary>
          <ul>
            {(findings.assumed ?? []).map((sentence) => (
              <li key={sentence}>{sentence}</li>
            ))}
          </ul>
        </details>
      )}
    </section>
  );
}

function Best({ best }: { best: KnownForce | undefined }) {
  if (best === undefined) return null;
  const { layout, force } = best;
  const range = rangeByDrift(force);
  return (
    <p>
      <strong>
        {name(force.axis)} is known to {fixed(force.fresh.rmse_n, 2)} N by {layoutWords(layout)}
      </strong>
      , on runs with other films{range !== null && `; ${fixed(range[0], 2)} to ${fixed(range[1], 2)} N by the drift of the readings`}. With one film dead,
      undetected, it is off by {fixed(force.dead?.error.rmse_n, 2)} N, with films {fixed(force.askew.std_deg, 0)}° off by {fixed(force.askew.error.rmse_n, 2)}{" "}
      N.
    </p>
  );
}

/** What a force's error costs in films, beside what one instant's readings allow. */
function Prices({ known, prices }: { known: KnownForce[]; prices: ForcePrice[] }) {
  const axes = [...new Set(prices.map((price) => price.axis))];
  return (
    <>
      {axes.map((axis) => {
        const words = prices
          .filter((price) => price.axis === axis)
          .map((price) => `${price.films} films to ${fixed(price.rmse_n, 2)} N (bound ${fixed(floorOf(known, price), 2)})`);
        return (
          <p key={axis}>
            {name(axis)} is known by {words.join(", by ")}. The bound is about what one instant's readings allow.
          </p>
        );
      })}
    </>
  );
}

const ELSEWHERE = view(ELSEWHERE_COLUMNS, "other tires");
const DRIFTS = view(DRIFTS_COLUMNS, "drift");

/** The same estimators on other tires. */
function OtherTires({ known }: { known: KnownForce[] }) {
  const rows = known.flatMap((one) =>
    (one.force.elsewhere ?? []).map((other) => ({
      ...one,
      change: other.learnt ? `${other.tire}, learnt from` : other.tire,
      row: { force: one.force, other },
    })),
  );
  return <Changed title="On other tires" changed="Tire" columns={ELSEWHERE} rows={rows} />;
}

/** The same films where their readings drift otherwise: how far they wander decides how many are needed. */
function Drifts({ known }: { known: KnownForce[] }) {
  const rows = known.flatMap((one) => (one.force.drift ?? []).map((drift) => ({ ...one, change: drift.drift, row: { force: one.force, drift } })));
  return <Changed title="With another drift" changed="Drift, of full scale" columns={DRIFTS} rows={rows} />;
}

/** The same films under contacts that differ in angle, load and shear alone: what camber and uneven ground cost. */
function Alike({ known }: { known: KnownForce[] }) {
  const rows = known.flatMap((one) => {
    const { alike } = one.force;
    return alike ? [{ ...one, change: "upright, flat", row: { force: one.force, drift: alike } }] : [];
  });
  return <Changed title="Upright, on flat ground" changed="Contacts" columns={DRIFTS} rows={rows} />;
}

interface ChangedProps {
  title: string;
  changed: string;
  columns: typeof ELSEWHERE;
  rows: (KnownForce & { change: string; row: object })[];
}

/** Forces where one thing is other than the study has it. */
function Changed({ title, changed, columns, rows }: ChangedProps) {
  if (rows.length === 0) return null;
  return (
    <details>
      <summary>{title}</summary>
      <ScrollTable name={`Forces: ${title.toLowerCase()}`} columns={[words(changed), words("Layout"), "Force", ...columns.map(heading)]}>
        <tbody>
          {rows.map(({ layout, force, change, row }) => (
            <tr key={`${change} ${layout.rank} ${force.axis}`}>
              <td class="words">{change}</td>
              <th scope="row" class="words layout-name">
                {layoutWords(layout)}
              </th>
              <td>{name(force.axis)}</td>
              <FigureCells columns={columns} row={row} />
            </tr>
          ))}
        </tbody>
      </ScrollTable>
    </details>
  );
}

const FIGURES = view(FORCES_COLUMNS, "known", "where", "leak");

function KnownTable({ known }: { known: KnownForce[] }) {
  return (
    <ScrollTable name="Forces that layouts' films tell" columns={["Films", words("Layout"), ...FIGURES.map(heading)]}>
      <tbody>
        {known.map(({ layout, force }) => (
          <tr key={`${layout.rank} ${force.axis}`}>
            <td>{layout.film_count}</td>
            <th scope="row" class="words layout-name">
              {layoutWords(layout)}
            </th>
            <FigureCells columns={FIGURES} row={{ force }} />
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}

function TableNote({ table }: { table: TableReport }) {
  return (
    <p class="quiet">
      The rig reads a table of {table.solves} solves on the {table.level} mesh, up to {table.largest_load_n} N
      {table.error == null
        ? "; a load that tests it has no equilibrium."
        : `: off by ${fixed(100 * table.error.signal_worst, 2)} % of a film's full scale at most, ${fixed(100 * table.error.signal_rms, 3)} % rms, at ${table.error.solves} solves that it wasn't made of.`}
    </p>
  );
}

const name = (axis: string): string => axis.replace("f", "F");
