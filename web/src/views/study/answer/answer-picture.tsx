import { unitLines } from "../../../lib/layouts/layout-words.ts";
import { filmsOf, shapeOf } from "../../../lib/layouts/wheel-films.ts";
import { answersLayout } from "../../../lib/study/result-picks.ts";
import type { Answer, RankedLayout, StudyDetail, StudyResult } from "../../../wire.ts";
import { Figure } from "../../shared/picture/figure.tsx";
import { FilmKey } from "../wheel/film-key.tsx";
import { SectionDrawing } from "../wheel/section-drawing.tsx";
import { WheelDrawing } from "../wheel/wheel-drawing.tsx";

/** The tire with the films of the answer in place, and the best place or all of them. */
export function AnswerPicture({ result, study, answer }: { result: StudyResult; study: StudyDetail; answer: Answer | null }) {
  const layout = answersLayout(result);
  const films = layout === null ? [] : filmsOf(layout);
  const shape = shapeOf(study.document);
  const { locations } = result.cut_point;
  const best = answer?.place?.names ?? [];
  return (
    <Figure class="answer-picture" study={study.name} name="answer">
      <WheelDrawing
        shape={shape}
        depth_mm={result.cut_point.depth_mm}
        films={films}
        size_mm={result.layout_findings?.size_mm ?? null}
        contact_deg={0}
        places={best.length === 0 ? locations : locations.filter(({ name }) => best.includes(name))}
        best={best}
        lines={layout === null ? [] : unitLines(layout)}
        label={labelOf(answer, layout)}
      />
      {films.length > 0 && <SectionDrawing shape={shape} films={films} />}
      {films.length > 0 && <FilmKey films={films} />}
    </Figure>
  );
}

function labelOf(answer: Answer | null, layout: RankedLayout | null): string {
  const places = answer?.place?.names.join(", ") ?? "";
  const parts = [layout === null ? "" : `films in place: ${answer?.layout?.words ?? ""}`, places === "" ? "" : `best place ${places}`];
  return `The wheel from the side, ground below. ${parts.filter((part) => part !== "").join("; ")}`;
}
