import type { WheelFilm } from "../../../lib/layouts/wheel-films.ts";

const KINDS = [
  { kind: "film-x", words: "x, around", isOf: (angle: number) => angle === 0 },
  { kind: "film-y", words: "y, across", isOf: (angle: number) => angle === 90 },
  { kind: "film-other", words: "oblique", isOf: (angle: number) => angle !== 0 && angle !== 90 },
] as const;

/** What the colours of films mean, of those that are drawn. */
export function FilmKey({ films }: { films: readonly WheelFilm[] }) {
  const shown = KINDS.filter(({ isOf }) => films.some((film) => isOf(film.angle_deg)));
  return (
    <p class="key">
      {shown.map(({ kind, words }) => (
        <span key={kind}>
          <svg viewBox="0 0 18 12" aria-hidden="true">
            <rect class={kind} y={2} width={18} height={8} />
          </svg>
          {words}
        </span>
      ))}
    </p>
  );
}
