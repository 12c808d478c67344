import { filmWord, short } from "../../../../lib/layouts/layout-words.ts";
import { dropped, movedTo } from "../../../../lib/layouts/moving/moved-films.ts";
import type { FilmPlace } from "../../../../wire.ts";
import type { MovingFilms } from "./use-moved-films.ts";

/** Degrees by an arrow key, and with Shift. */
const STEP_DEG = 1;
const LEAP_DEG = 5;

/** Every film as a button: keys on it move it. */
export function FilmButtons({ moved }: { moved: MovingFilms }) {
  const { films, chosen } = moved;

  function press(event: KeyboardEvent, index: number, film: FilmPlace): void {
    const by = event.shiftKey ? LEAP_DEG : STEP_DEG;
    const steps: Record<string, number> = { ArrowLeft: -by, ArrowDown: -by, ArrowRight: by, ArrowUp: by };
    const step = steps[event.key];
    if (step !== undefined) moved.change(movedTo(films, index, film.theta_deg + step), index);
    else if (event.key === "Delete" || event.key === "Backspace") moved.change(dropped(films, index), index);
    else return;
    event.preventDefault();
  }

  return (
    <div class="film-buttons" role="group" aria-label="Films by their angle around the wheel">
      {films.map((film, k) => (
        <button
          key={k}
          type="button"
          aria-pressed={k === chosen}
          onClick={() => moved.choose(k)}
          onFocus={() => moved.choose(k)}
          onKeyDown={(event) => press(event, k, film)}
        >
          {words(film)}
        </button>
      ))}
    </div>
  );
}

/** `y 120°`, and where in the section off the crown. */
function words({ theta_deg, phi_deg, angle_deg }: FilmPlace): string {
  return `${filmWord(short(angle_deg))} ${short(theta_deg, 4)}°${phi_deg === 0 ? "" : ` (${short(phi_deg)}°)`}`;
}
