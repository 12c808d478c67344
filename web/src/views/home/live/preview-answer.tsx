import { firstOf } from "../../../lib/study/answer/answer-words.ts";
import { filmsOnSheet, shapeOf } from "../../../lib/layouts/wheel-films.ts";
import type { Preview } from "../../../wire.ts";
import { FilmKey } from "../../study/wheel/film-key.tsx";
import { WheelDrawing } from "../../study/wheel/wheel-drawing.tsx";

/** The layout that the draft would answer with, on the tire as it is now; nothing where no layouts are asked for. */
export function PreviewAnswer({ preview: { answer, cut_point }, scene }: { preview: Preview; scene: unknown }) {
  if (answer?.layout == null) return null;
  const films = filmsOnSheet(answer.films ?? []);
  return (
    <div class="preview-answer">
      <WheelDrawing
        shape={shapeOf({ scene })}
        depth_mm={cut_point.depth_mm}
        films={films}
        size_mm={sizeOf(answer.films ?? [])}
        contact_deg={0}
        places={[]}
        best={[]}
        lines={[]}
        label={`The wheel from the side with ${answer.layout.words}`}
      />
      <div>
        <p>{firstOf(answer.sentence)}</p>
        <FilmKey films={films} />
      </div>
    </div>
  );
}

/** Length and width of the films; null of points. */
function sizeOf([first]: readonly { length_mm?: number | null; width_mm?: number | null }[]): [number, number] | null {
  return first?.length_mm == null || first.width_mm == null ? null : [first.length_mm, first.width_mm];
}
