import { percent } from "../../../lib/format.ts";
import { bestOfFew, isPapers, layoutWords, loadWords, LOST_DEG, short, worstLoad } from "../../../lib/layouts/layout-words.ts";
import type { LayoutScore, RankedLayout } from "../../../wire.ts";

/** What the reader came for: the layout that answers, or else the first, and what it knows; then the one with the smallest error, and the paper's. */
export function LayoutAnswer({ layouts, answers }: { layouts: RankedLayout[]; answers: RankedLayout | null }) {
  const best = answers ?? layouts[0];
  if (best?.score.simulated_p95_angle_error_deg == null) return null;
  const papers = layouts.find(isPapers);
  const surest = bestOfFew(layouts, Infinity);
  return (
    <div class="layout-answer">
      <p class="headline">
        {!isFound(best.score) ? "No layout here finds the contact. The least bad: " : best === answers ? "The answer: " : "Best: "}
        <strong>{layoutWords(best)}</strong>. In 95 % of contacts it knows <Knowledge layout={best} />
        <Dead score={best.score} />. {best === layouts[0] && <Certainty best={best} next={layouts[1]} />}
      </p>
      {surest !== null && surest !== best && (
        <p class="headline">
          Smallest error: <strong>{layoutWords(surest)}</strong>, {angleWords(surest.score)}.
        </p>
      )}
      {papers !== undefined && papers !== best && <Papers papers={papers} layouts={layouts} />}
    </div>
  );
}

const isFound = ({ simulated_p95_angle_error_deg: p95 }: LayoutScore): boolean => p95 != null && p95 <= LOST_DEG;

/** `0.87 ± 0.21°` */
function angleWords({ simulated_p95_angle_error_deg: p95, error }: LayoutScore): string {
  const off = error?.simulated_p95_angle_error_deg;
  return off == null ? `${short(p95, 2)}°, error unknown` : `${short(p95, 2)} ± ${short(off, 2)}°`;
}

function Knowledge({ layout }: { layout: RankedLayout }) {
  const { score } = layout;
  const load = worstLoad(layout);
  const at = layout.loads.length > 1 ? "at its worst load, " : "at ";
  return (
    <>
      the contact angle to <strong>{angleWords(score)}</strong>
      {load !== null && `, ${at}${loadWords(load)}`}
      <Force layout={layout} />
      {score.lost_share != null && score.lost_share > 0 && `; ${percent(score.lost_share, 1)} % of contacts are off by more than ${LOST_DEG}°`}
    </>
  );
}

/** `, and the vertical force to 3.05 ± 0.35 N rms, at 34.7 N`; nothing of a result from before it had that. */
function Force({ layout: { worst_force: force, loads } }: { layout: RankedLayout }) {
  if (force == null) return null;
  const off = force.claim_n == null ? "" : ` ± ${short(force.claim_n, 2)}`;
  return (
    <>
      , and the vertical force to <strong>{`${short(force.error_n, 2)}${off} N`}</strong> rms
      {loads.length > 1 && `, at ${short(force.load_n)} N`}
    </>
  );
}

/** What is left with the worst film dead. */
function Dead({ score }: { score: LayoutScore }) {
  const dead = score.dead?.simulated_p95_angle_error_deg;
  const whole = score.simulated_p95_angle_error_deg;
  if (dead == null || whole == null) return null;
  const isWorse = dead > whole + (score.error?.simulated_p95_angle_error_deg ?? 0);
  return <>{isWorse ? `; with one film dead the angle only to ${short(dead, 2)}°` : "; one dead film changes no more than the error of that"}</>;
}

function Certainty({ best, next }: { best: RankedLayout; next: RankedLayout | undefined }) {
  if (next === undefined) return null;
  if (best.rank_certain === true) return <>That it ranks first is certain.</>;
  return <>{`That it ranks first isn't certain; next: ${layoutWords(next)} (${angleWords(next.score)}).`}</>;
}

/** The paper's layout, and what as many films could do. */
function Papers({ papers, layouts }: { papers: RankedLayout; layouts: RankedLayout[] }) {
  const other = bestOfFew(layouts, papers.film_count);
  return (
    <p class="headline">
      The paper's layout, <strong>{layoutWords(papers)}</strong>, ranks {papers.rank} of {layouts.length}: it would know <Knowledge layout={papers} />.
      {other !== null && other !== papers && ` With no more films, ${layoutWords(other)} would know the angle to ${angleWords(other.score)}.`}
    </p>
  );
}
