import { fixed, integer, significant } from "../../../lib/format.ts";
import type { Choice, StudyResult } from "../../../wire.ts";

/** What was modelled, what was left out and why, and the answer at the means. */
export function ModelPanel({ result }: { result: StudyResult }) {
  const { model, cut_point: cut } = result;
  return (
    <section class="panel" aria-labelledby="model-title">
      <h2 id="model-title">Model</h2>
      <p>
        {model.dimension}, level {model.level}: {integer(model.elements)} elements, {integer(model.dofs)} displacement unknowns. At the means (
        {result.inputs.map((input, i) => `${input.name}=${significant(cut.values[i], 3)}`).join(", ")}): ground force {fixed(cut.reaction_n, 2)} N
        {cut.depth_mm === undefined ? "" : ` at a depth of ${fixed(cut.depth_mm, 3)} mm`}, outer radius after inflation {fixed(cut.inflated_outer_radius_mm, 2)}{" "}
        mm.
      </p>
      <div class="columns">
        <Choices title="Modelled" choices={model.modelled} />
        <Choices title="Left out" choices={model.left_out} />
      </div>
    </section>
  );
}

function Choices({ title, choices }: { title: string; choices: Choice[] }) {
  return (
    <div>
      <h3>{title}</h3>
      {choices.length === 0 ? (
        <p class="quiet">Nothing.</p>
      ) : (
        <dl class="choices">
          {choices.map((choice) => (
            <div key={choice.what}>
              <dt>{choice.what}</dt>
              <dd>
                {choice.why}
                {choice.effect != null && choice.effect !== 0 && <span class="effect"> Effect on the strains: {significant(100 * choice.effect, 2)} %.</span>}
              </dd>
            </div>
          ))}
        </dl>
      )}
    </div>
  );
}
