import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import * as api from "../../../../api.ts";
import { createNewestWaits } from "../../../../lib/document/newest-waits.ts";
import { short } from "../../../../lib/layouts/layout-words.ts";
import { areTwice, filmsText, MOST_FILMS } from "../../../../lib/layouts/moving/moved-films.ts";
import { answerTo, type Loadable } from "../../../../state/loadable.ts";
import type { FilmPlace, LayoutScore, RankedLayout, ScoredLayouts } from "../../../../wire.ts";
import { ProblemBox } from "../../../shared/problem-box.tsx";

/** As long as nothing moves before the service is asked. */
const REST_MS = 400;

interface Props {
  study: string;
  films: FilmPlace[];
  layout: RankedLayout;
  isMoved: boolean;
}

interface Answer {
  of: string;
  scored: Loadable<ScoredLayouts>;
}

/** What the service simulates of the films once they rest. */
export function MovedScore({ study, films, layout, isMoved }: Props) {
  const [answer, setAnswer] = useState<Answer | null>(null);
  const isHere = useRef(true);
  useEffect(
    () => () => {
      isHere.current = false;
    },
    [],
  );
  const waits = useMemo(
    () =>
      createNewestWaits(async (asked: FilmPlace[]) => {
        const scored = await answerTo(api.scoreLayout(study, asked));
        if (isHere.current) setAnswer({ of: filmsText(asked), scored });
      }),
    [study],
  );
  const text = filmsText(films);
  const canAsk = isMoved && films.length > 0 && films.length <= MOST_FILMS && !areTwice(films);
  useEffect(() => {
    waits.drop();
    if (!canAsk) return undefined;
    const timer = window.setTimeout(() => waits.offer(films), REST_MS);
    return () => window.clearTimeout(timer);
  }, [text, canAsk]);
  const before = `The layout it came from: ${p95Words(layout.score)}.`;
  if (!canAsk) return <p>Simulated, 95 % of contacts. {before}</p>;
  if (answer?.of !== text) return <p>Simulated, 95 % of contacts: the service is asked once the films rest. {before}</p>;
  if (answer.scored.status === "failed") return <ProblemBox problem={answer.scored.problem} />;
  if (answer.scored.status === "loading") return null;
  const moved = answer.scored.value.layouts[0];
  return (
    <p>
      Simulated, 95 % of contacts: <strong>{moved === undefined ? "unknown" : p95Words(moved.score)}</strong>, the vertical force to{" "}
      {short(moved?.worst_force?.error_n, 2)} N rms. {before}
    </p>
  );
}

/** `0.87 ± 0.21°` */
function p95Words({ simulated_p95_angle_error_deg: p95, error }: LayoutScore): string {
  if (p95 == null) return "unknown";
  const off = error?.simulated_p95_angle_error_deg;
  return off == null ? `${short(p95, 2)}°, error unknown` : `${short(p95, 2)} ± ${short(off, 2)}°`;
}
