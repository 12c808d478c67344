import { fixed, integer, MISSING } from "../../lib/format.ts";
import { formatRoute, studyRoute } from "../../lib/route.ts";
import { nameSaysAll, settingsText } from "../../lib/sweep/design-progress.ts";
import type { ComparedStudy, Comparison, DesignView } from "../../wire.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";
import { StateBadge } from "../shared/state-badge.tsx";

/** Columns that only a design with a result fills. */
const FIGURES = ["Force N", "Signal x µε", "Signal y µε", "Best", "Solves", "Reused", "Time s"];

/** Studies that are ticked to be compared. */
export interface Ticking {
  ticked: readonly string[];
  onTick: (study: string, on: boolean) => void;
}

interface Props extends Ticking {
  designs: DesignView[];
  comparison: Comparison | null;
}

/** The designs in the order of the sweep, each with its figures or with the reason why it has none. */
export function DesignTable({ designs, comparison, ticked, onTick }: Props) {
  const compared = new Map(comparison?.studies.map((study) => [study.id, study]));
  return (
    <ScrollTable name="Designs" kind="designs" isTall columns={["#", words("Design"), { text: "State", class: "state" }, ...FIGURES]}>
      <tbody>
        {designs.map((design) => (
          <Row key={design.ordinal} design={design} compared={compared.get(design.study.id)} ticked={ticked} onTick={onTick} />
        ))}
      </tbody>
    </ScrollTable>
  );
}

function Row({ design, compared, ticked, onTick }: { design: DesignView; compared: ComparedStudy | undefined } & Ticking) {
  const { study } = design;
  return (
    <tr data-design={design.ordinal}>
      <td>{design.ordinal + 1}</td>
      <th scope="row" class="words">
        {study.state === "done" && (
          <input
            type="checkbox"
            class="design-tick"
            title="Compare"
            aria-label={`Compare ${design.name}`}
            checked={ticked.includes(study.id)}
            onChange={(event) => onTick(study.id, event.currentTarget.checked)}
          />
        )}
        <a href={formatRoute(studyRoute(study.id))}>{design.name}</a>
        {!nameSaysAll(design) && <span class="error settings">{settingsText(design.set)}</span>}
      </th>
      <td class="state">
        <StateBadge state={study.state} />
      </td>
      {study.error == null ? (
        <Figures study={compared} />
      ) : (
        <td class="words reason" colSpan={FIGURES.length}>
          {study.error}
        </td>
      )}
    </tr>
  );
}

function Figures({ study }: { study: ComparedStudy | undefined }) {
  const cost = study?.cost;
  return (
    <>
      <td>{fixed(study?.reaction_n, 2)}</td>
      <td>{signal(study?.std_strain_x)}</td>
      <td>{signal(study?.std_strain_y)}</td>
      <td>{best(study)}</td>
      <td>{integer(cost && cost.solves + (cost.coarser_solves ?? 0) + (cost.effect_solves ?? 0) + (cost.signal_solves ?? 0))}</td>
      <td>{integer(cost?.reused)}</td>
      <td>{fixed(cost?.wall_s, 2)}</td>
    </>
  );
}

function signal(strain: number | null | undefined): string {
  return integer(strain == null ? null : 1e6 * strain);
}

function best(study: ComparedStudy | undefined) {
  if (study?.best == null) return MISSING;
  return (
    <>
      <strong>{study.best}</strong> <span class="error">{study.best_certain === true ? "certain" : "uncertain"}</span>
    </>
  );
}
