import * as api from "../../../../api.ts";
import { areTwice, filmsFrom, filmsText, freeLayoutToml, nameOf } from "../../../../lib/layouts/moving/moved-films.ts";
import { readyFields } from "../../../../lib/layouts/moving/layout-bounds.ts";
import { filmsOf } from "../../../../lib/layouts/wheel-films.ts";
import { againRoute, formatRoute } from "../../../../lib/route.ts";
import { useAsked } from "../../../../state/use-asked.ts";
import type { FilmFields, FilmPlace, RankedLayout } from "../../../../wire.ts";
import { Loaded } from "../../../shared/loaded.tsx";
import type { SectionProps } from "../../section-props.ts";
import { useMemo, useState } from "preact/hooks";
import { FilmEditor } from "./film-editor.tsx";
import { MovedBounds } from "./moved-bounds.tsx";
import { MovedScore } from "./moved-score.tsx";
import { useMovedFilms } from "./use-moved-films.ts";

interface Props extends Pick<SectionProps, "study" | "result" | "route" | "onAdjust"> {
  /** Where the films stood at first. */
  layout: RankedLayout;
}

/** A layout whose films are moved by hand, with the scores at once. */
export function MovingPanel(props: Props) {
  const [attempt, retry] = useState(0);
  const fields = useAsked(`${props.study.id} ${attempt}`, () => api.filmFields(props.study.id));
  if (fields === null) return null;
  return (
    <Loaded of={fields} what="what films read" onRetry={() => retry(attempt + 1)}>
      {(value) => <Moving {...props} fields={value} />}
    </Loaded>
  );
}

function Moving({ study, result, route, onAdjust, layout, fields }: Props & { fields: FilmFields }) {
  const begun = useMemo(() => placesOf(layout), [layout]);
  const ready = useMemo(() => readyFields(fields), [fields]);
  const onFilms = (films: FilmPlace[] | null): void => onAdjust({ ...route, films: films === null ? null : filmsText(films) });
  const moved = useMovedFilms(begun, filmsFrom(route.films), onFilms);
  const { films } = moved;
  return (
    <>
      <div class="turning-body">
        <FilmEditor study={study} result={result} fields={fields} moved={moved} />
        <div>
          <MovedBounds ready={ready} films={films} begun={begun} />
          <MovedScore study={study.id} films={films} layout={layout} isMoved={filmsText(films) !== filmsText(begun)} />
          {areTwice(films) && <p class="flag">Two films of one kind lie at one place: the service takes that for a mistake. Move one of them.</p>}
        </div>
      </div>
      {films.length > 0 && <Kept study={study.id} films={films} />}
    </>
  );
}

/** What is left of it: text for a document, and the form of a study that has it. */
function Kept({ study, films }: { study: string; films: readonly FilmPlace[] }) {
  return (
    <>
      <p>
        <a class="run-again" href={formatRoute(againRoute(study, filmsText(films)))}>
          Run the study again with this layout
        </a>
      </p>
      <details>
        <summary>As TOML, to copy into a study</summary>
        <pre class="moved-toml" tabIndex={0} role="group" aria-label="The layout as TOML">
          {freeLayoutToml(nameOf(1), films)}
        </pre>
      </details>
    </>
  );
}

function placesOf(layout: RankedLayout): FilmPlace[] {
  return filmsOf(layout).map(({ theta_deg, section_deg, angle_deg }) => ({ theta_deg, phi_deg: section_deg, angle_deg }));
}
