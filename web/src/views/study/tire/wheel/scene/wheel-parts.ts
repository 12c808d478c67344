import { Group, Mesh, type BufferGeometry, type DataTexture, type ShaderMaterial } from "three";
import { patchOn, PATCH_GRID, type PatchSize, type ShownFilm } from "../../../../../lib/tire/surface/film-patches.ts";
import { isWheel, type Surface } from "../../../../../lib/tire/surface/surface-reader.ts";
import type { Rulers } from "../../../../../lib/tire/map/arc-length.ts";
import type { Raster } from "../../../../../lib/tire/map/field-raster.ts";
import type { PlaceMark } from "../../../../../lib/tire/map/surface-field.ts";
import { BARE, FILM, GROUND, OUTER, PLACE, RIM, WALL } from "../skin-colours.ts";
import { gridGeometry, placesOnMap, stillGeometry, wallGeometry } from "./part-geometry.ts";
import { skinMaterial, type SharedUniforms } from "./skin-material.ts";

/** The place of a film that is a point, and of P1 ..., mm: not their true size. */
const POINT_FILM_MM: PatchSize = [5, 1.6];
const PLACE_MM: PatchSize = [2.6, 2.6];
/** The ground is drawn this far to both sides, as a multiple of the bead's half width. */
const GROUND_WIDTH = 2;
const CLEAR = 0.22;

/** The tire itself: skins, walls between them, rim and ground. */
export function tireParts(shared: SharedUniforms, surface: Surface, picture: DataTexture | null, map: { rulers: Rulers; raster: Raster } | null): Group {
  const group = new Group();
  const onMap = map === null ? null : placesOnMap(surface, map.rulers, map.raster);
  add(group, gridGeometry(surface, surface.inner, onMap), skinMaterial(shared, { colour: BARE, picture: onMap === null ? null : picture }));
  if (surface.outer !== null) {
    const isClear = !shared.isCut.value;
    add(group, gridGeometry(surface, surface.outer, null), skinMaterial(shared, { colour: OUTER, opacity: isClear ? CLEAR : 1 }));
  }
  const middle = surface.phi_deg.indexOf(0);
  for (const row of [0, surface.phi_deg.length - 1, ...(shared.isCut.value && middle > 0 ? [middle] : [])]) {
    // A hair on the side that stays when the other is cut away.
    add(group, wallGeometry(surface, row), skinMaterial(shared, { colour: WALL, staysWhole: row === middle }));
  }
  if (isWheel(surface)) add(group, rimGeometry(surface), skinMaterial(shared, { colour: RIM, opacity: CLEAR }));
  // The ground is where it presses: drawn only where the tire is, too.
  if (surface.ground !== null && shared.factor.value === 1)
    add(group, groundGeometry(surface), skinMaterial(shared, { colour: GROUND, opacity: 0.4, staysWhole: true }));
  return group;
}

/** Films of a layout, and P1 ... as discs, or as films where the study's have a size. */
export function markParts(shared: SharedUniforms, surface: Surface, places: readonly PlaceMark[], films: readonly ShownFilm[], size: PatchSize | null): Group {
  const group = new Group();
  const patch = (film: ShownFilm, shape: PatchSize, colour: typeof FILM, isRound: boolean): void => {
    const skin = patchOn(surface, surface.inner, film, shape, isRound);
    if (skin !== null) add(group, gridGeometry(PATCH_GRID, skin, null), skinMaterial(shared, { colour, staysWhole: true }));
  };
  places.forEach((place) => patch({ ...place, angle_deg: 0 }, size ?? PLACE_MM, PLACE, size === null));
  films.forEach((film) => patch(film, size ?? POINT_FILM_MM, film.colour ?? FILM, false));
  return group;
}

/** Frees what a group holds on the graphics card. */
export function freeParts(group: Group): void {
  for (const part of group.children as Mesh<BufferGeometry, ShaderMaterial>[]) {
    part.geometry.dispose();
    part.material.dispose();
  }
}

function add(group: Group, geometry: BufferGeometry | null, material: ShaderMaterial): void {
  if (geometry === null) return;
  const mesh = new Mesh(geometry, material);
  // Points are moved on the card, so what the geometry says of its bounds isn't the last word.
  mesh.frustumCulled = false;
  group.add(mesh);
}

/** A plain cylinder between the beads. */
function rimGeometry({ theta_deg, phi_deg, inner }: Surface): BufferGeometry {
  const columns = theta_deg.length;
  const row = (index: number): [number, number, number][] =>
    theta_deg.map((_, column) => {
      const k = 3 * (index * columns + column);
      return [inner.inflated[k] as number, inner.inflated[k + 1] as number, inner.inflated[k + 2] as number];
    });
  return stillGeometry([row(0), row(phi_deg.length - 1)]);
}

/** The ground's profile, as wide as the tire's section and a little more. */
function groundGeometry({ ground, inner }: Surface): BufferGeometry | null {
  if (ground === null) return null;
  const half = GROUND_WIDTH * Math.abs(inner.inflated[1] ?? 0);
  const camber = (ground.camber_deg * Math.PI) / 180;
  const [sin, cos] = [Math.sin(camber), Math.cos(camber)];
  const inWheel = (x: number, y: number, z: number): [number, number, number] => [x, cos * y + sin * z, cos * z - sin * y];
  return stillGeometry([-half, half].map((y) => ground.x_mm.map((x, k) => inWheel(x, y, ground.z_mm[k] as number))));
}
