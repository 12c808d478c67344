import type { ComponentChildren } from "preact";
import { useMemo, useRef } from "preact/hooks";
import { aboutWheel, nearer, turnedBy, type ViewName } from "../../../../lib/tire/eye/orbit.ts";
import { pixelOf, rayThrough, type Camera } from "../../../../lib/tire/eye/perspective.ts";
import { pick } from "../../../../lib/tire/eye/ray-pick.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";
import type { PlaceMark } from "../../../../lib/tire/map/surface-field.ts";
import { deformed, placeOn, trianglesOf } from "../../../../lib/tire/surface/skin-geometry.ts";
import type { Surface } from "../../../../lib/tire/surface/surface-reader.ts";
import type { Sight } from "../../../../lib/tire/view-address.ts";
import { pngOf, save } from "../../../shared/picture/picture-file.ts";
import { sheetOf, withLegend } from "../../../shared/picture/picture-sheet.ts";
import type { MapModel } from "../tire-model.ts";
import { useDrag } from "./use-drag.ts";
import type { MovedEye } from "./use-eye.ts";
import { useScene, type DrawnScene, type SceneState } from "./use-scene.ts";
import type { WheelActions } from "./wheel-buttons.tsx";

interface Saved {
  title: string;
  file: string;
}

interface Props {
  model: MapModel;
  surface: Surface;
  title: string;
  /** Of the wheel that the eye goes about, mm: of several that are drawn to one scale it is one. */
  radius_mm: number;
  sight: Pick<Sight, "factor" | "isCut" | "pin">;
  eye: MovedEye;
  actions: WheelActions;
  point: SurfacePoint | null;
  onPoint: (point: SurfacePoint | null) => void;
  onPin: (point: SurfacePoint | null) => void;
  /** Title of the saved picture, and the name of its file. */
  saved?: Saved;
  /** What stands below the picture, for which the scene can be saved; beside a missing one it stands not. */
  children?: (save: () => void) => ComponentChildren;
  /** In place of the picture where there can't be one. */
  missing?: ComponentChildren;
}

/** Beyond the cut so far a place can still be picked: the marks of P1 ... stand out by half. */
const EDGE_MM = 1.3;
const TURN_DEG = 8;
const ZOOM = 1.2;
const VIEW_KEYS: Record<string, ViewName> = { "1": "front", "2": "side", "3": "top", "4": "section", r: "start" };

/** One wheel, turned by the pointer and the keys. */
export function WheelCanvas({ model, surface, title, radius_mm, sight, eye, actions, point, onPoint, onPin, saved, children, missing }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { factor, isCut, pin } = sight;
  const points = useMemo(() => deformed(surface.inner, factor), [surface, factor]);
  const triangles = useMemo(() => trianglesOf(surface), [surface.theta_deg]);
  const pointer = point === null ? null : placeOn(surface, points, point);
  const { shown, rulers, places, films, filmSize } = model;
  const orbit = useMemo(() => aboutWheel(eye.orbit, radius_mm), [eye.orbit, radius_mm]);
  const { state, size, draw } = useScene(canvas, { surface, raster: shown?.raster ?? null, rulers, places, films, filmSize, factor, isCut, pointer }, orbit);
  const camera: Camera = { orbit, ...size };
  const under = (x: number, y: number): SurfacePoint | null =>
    pick(surface, points, triangles, rayThrough(camera, x, y), ([, across]) => !isCut || across >= -EDGE_MM);
  const drag = useDrag({
    turn: (right, down) => eye.set(turnedBy(eye.orbit, -right / 3, down / 3)),
    hover: (x, y) => onPoint(x === null ? null : under(x, y)),
    click: (x, y) => onPin(under(x, y)),
  });
  const press = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") onPin(null);
    else if (event.key === "Enter" && point !== null) onPin(point);
    else if (!act(event.key, actions)) return;
    event.preventDefault();
    // 1 to 4 are views here, and sections elsewhere.
    event.stopPropagation();
  };
  const labels = labelsOf([...(pin === null ? [] : [{ ...pin, name: "pin" }]), ...places], (place) => {
    const at = placeOn(surface, points, place);
    return at === null ? null : pixelOf(camera, at);
  });
  if (state === "none" || state === "lost") return <>{missing ?? <NoPicture state={state} />}</>;
  return (
    <div>
      <div
        class="wheel"
        tabIndex={0}
        role="application"
        onKeyDown={press}
        {...drag}
        aria-label={`Tire in three dimensions: ${title}. Arrow keys turn, plus and minus zoom, 1 to 4 are views, c cuts, r resets.`}
      >
        <canvas ref={canvas} aria-hidden="true" data-drawn={state === "ready" ? "yes" : "no"} />
        {state === "loading" && (
          <p class="quiet wheel-drawing" role="status">
            Drawing the tire …
          </p>
        )}
        {labels.map((label) => (
          <Label key={label.name} {...label} />
        ))}
      </div>
      {children?.(() => void (saved !== undefined && savePicture(canvas.current, draw, saved)))}
    </div>
  );
}

/** What keys and buttons do to the eye, the cut and the deformation. */
export function wheelActions(eye: MovedEye, isCut: boolean, onSight: (change: Partial<Sight>) => void): WheelActions {
  return {
    turn: (azimuth, elevation) => eye.set(turnedBy(eye.orbit, azimuth, elevation)),
    zoom: (nearby) => eye.set(nearer(eye.orbit, nearby, 1)),
    goTo: (name) => {
      if (name === "start") onSight({ isCut: true, factor: 1 });
      if (name === "section") onSight({ isCut: true });
      eye.ease(name);
    },
    cut: () => onSight({ isCut: !isCut }),
  };
}

/** With the names of places that stand on it. */
async function savePicture(canvas: HTMLCanvasElement | null, draw: DrawnScene["draw"], { title, file }: Saved): Promise<void> {
  draw();
  save(await pngOf(sheetOf(title, withLegend(canvas?.parentElement ?? null))), file);
}

/** Whether the key meant something. */
function act(key: string, { turn, zoom, goTo, cut }: WheelActions): boolean {
  const turns: Record<string, [number, number]> = {
    ArrowLeft: [-TURN_DEG, 0],
    ArrowRight: [TURN_DEG, 0],
    ArrowUp: [0, TURN_DEG],
    ArrowDown: [0, -TURN_DEG],
  };
  const by = turns[key];
  const view = VIEW_KEYS[key];
  if (by !== undefined) turn(...by);
  else if (key === "+" || key === "=") zoom(ZOOM);
  else if (key === "-") zoom(1 / ZOOM);
  else if (view !== undefined) goTo(view);
  else if (key === "c") cut();
  else return false;
  return true;
}

/** Pixels from one label to the next, at least. */
const LABEL_ROOM = { x: 22, y: 15 };

/** Names where they are seen, without those that would stand on an earlier one. */
function labelsOf(places: readonly PlaceMark[], pixel: (place: PlaceMark) => { x: number; y: number } | null): { name: string; x: number; y: number }[] {
  const labels: { name: string; x: number; y: number }[] = [];
  for (const place of places) {
    const at = pixel(place);
    const isFree = at !== null && labels.every(({ x, y }) => Math.abs(x - at.x) > LABEL_ROOM.x || Math.abs(y - at.y) > LABEL_ROOM.y);
    if (isFree) labels.push({ name: place.name, ...at });
  }
  return labels;
}

function Label({ name, x, y }: { name: string; x: number; y: number }) {
  return (
    <span class="wheel-label" aria-hidden="true" style={{ left: `${x.toFixed(1)}px`, top: `${y.toFixed(1)}px` }}>
      {name}
    </span>
  );
}

function NoPicture({ state }: { state: SceneState }) {
  const why =
    state === "lost"
      ? "The browser took the graphics card away from this page. Load the page again to turn the tire."
      : "This browser has no WebGL, so the tire can't be turned.";
  return (
    <div class="wheel wheel-missing">
      <p role="status">{why} The map beside shows the same values.</p>
    </div>
  );
}

/** Of the outermost point, mm. */
export function radiusOf({ inner, outer }: Surface): number {
  const points = (outer ?? inner).inflated;
  let most = 0;
  for (let k = 0; k + 2 < points.length; k += 3) most = Math.max(most, Math.hypot(points[k] as number, points[k + 2] as number));
  return most;
}
