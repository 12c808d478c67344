import { fixed, MISSING } from "../../../lib/format.ts";
import { AXIS_WORDS, bestKnown, type KnownForce, knownForces, untoldAxes } from "../../../lib/layouts/known-forces.ts";
import { layoutWords } from "../../../lib/layouts/layout-words.ts";
import type { ForceFindings, RankedLayout, TableReport } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

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
      {untold.length > 0 && <p>No layout's films tell more of {untold.map((axis) => `${name(axis)} (${AXIS_WORDS[axis] ?? axis})`).join(" and ")} than the training mean does.</p>}
      {known.length > 0 && <KnownTable known={known} />}
      {(findings.reasons ?? []).map((reason) => (
        <p key={reason} class="flag">
          {reason}
        </p>
      ))}
      {findings.table != null && <TableNote table={findings.table} />}
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
  return (
    <p>
      <strong>
        {name(force.axis)} is known to {fixed(force.fresh.rmse_n, 2)} N by {layoutWords(layout)}
      </strong>
      , on runs with other films. With one film dead, undetected, it is off by {fixed(force.dead?.error.rmse_n, 2)} N, with films {fixed(force.askew.std_deg, 0)}° off by{" "}
      {fixed(force.askew.error.rmse_n, 2)} N.
    </p>
  );
}

function KnownTable({ known }: { known: KnownForce[] }) {
  return (
    <ScrollTable name="Forces that layouts' films tell">
      <thead>
        <tr>
          <th scope="col">Films</th>
          <th scope="col" class="words">
            Layout
          </th>
          <th scope="col">Force</th>
          <th scope="col">Off by N</th>
          <th scope="col">NRMSE %</th>
          <th scope="col">R²</th>
          <th scope="col">Covered</th>
          <th scope="col">One dead N</th>
          <th scope="col">Films off N</th>
          <th scope="col">Worst contact</th>
          <th scope="col">Leak</th>
        </tr>
      </thead>
      <tbody>
        {known.map(({ layout, force }) => (
          <tr key={`${layout.rank} ${force.axis}`}>
            <td>{layout.film_count ?? layout.units}</td>
            <th scope="row" class="words layout-name">
              {layoutWords(layout)}
            </th>
            <td>{name(force.axis)}</td>
            <td>{fixed(force.fresh.rmse_n, 2)}</td>
            <td>{fixed(force.fresh.nrmse_percent, 1)}</td>
            <td>{fixed(force.fresh.r2, 2)}</td>
            <td>{fixed(force.fresh.coverage, 2)}</td>
            <td>{fixed(force.dead?.error.rmse_n, 2)}</td>
            <td>{fixed(force.askew.error.rmse_n, 2)}</td>
            <td>{force.worst_contact == null ? MISSING : `${fixed(force.worst_contact.rmse_n, 2)} N at ${fixed(force.worst_contact.deg, 1)}°`}</td>
            <td>{fixed(force.leak, 2)}</td>
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
