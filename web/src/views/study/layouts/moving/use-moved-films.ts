import { useState } from "preact/hooks";
import { begunWith, changed, filmsText, undone, type MovedFilms } from "../../../../lib/layouts/moving/moved-films.ts";
import type { FilmPlace } from "../../../../wire.ts";

/** Films being moved, and what can be done with them. */
export interface MovingFilms {
  films: FilmPlace[];
  /** The film that keys, pointer and fields change; null of none. */
  chosen: number | null;
  choose(index: number | null): void;
  /** Into a list of films; what is before it can be had again. */
  change(films: FilmPlace[], chosen: number | null): void;
  /** While a film is dragged: no step of its own. */
  drag(films: FilmPlace[]): void;
  undo: (() => void) | null;
  /** To where they stood at first. */
  restart: (() => void) | null;
}

/** Films that begin as a layout, or as the address has them; `onFilms` is told after each change, of null when they are the layout's again. */
export function useMovedFilms(begun: FilmPlace[], shared: FilmPlace[] | null, onFilms: (films: FilmPlace[] | null) => void): MovingFilms {
  const [moved, set] = useState<MovedFilms>(() => begunWith(shared ?? begun));
  const [chosen, choose] = useState<number | null>(null);
  const isBegun = (films: FilmPlace[]): boolean => filmsText(films) === filmsText(begun);

  function show(next: MovedFilms, index: number | null): void {
    set(next);
    choose(index !== null && index < next.films.length ? index : null);
    onFilms(isBegun(next.films) ? null : next.films);
  }

  return {
    films: moved.films,
    chosen,
    choose,
    change: (films, index) => show(changed(moved, films), index),
    drag: (films) => show({ ...moved, films }, chosen),
    undo: moved.past.length === 0 ? null : () => show(undone(moved), chosen),
    restart: isBegun(moved.films) ? null : () => show(changed(moved, begun), null),
  };
}
