/** The picture of the wheel by WebGL: draws what it is told, once for each time. */

import { DataTexture, Group, LinearFilter, Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, SphereGeometry, SRGBColorSpace, WebGLRenderer } from "three";
import type { Rulers } from "../../../../../lib/tire/map/arc-length.ts";
import type { Raster } from "../../../../../lib/tire/map/field-raster.ts";
import type { PlaceMark } from "../../../../../lib/tire/map/surface-field.ts";
import type { PatchSize, ShownFilm } from "../../../../../lib/tire/surface/film-patches.ts";
import { eyeOf } from "../../../../../lib/tire/eye/orbit.ts";
import { FIELD_OF_VIEW_DEG, type Camera } from "../../../../../lib/tire/eye/perspective.ts";
import type { Vec3 } from "../../../../../lib/tire/surface/skin-geometry.ts";
import type { Surface } from "../../../../../lib/tire/surface/surface-reader.ts";
import { POINTER } from "../skin-colours.ts";
import type { SharedUniforms } from "./skin-material.ts";
import { freeParts, markParts, tireParts } from "./wheel-parts.ts";

/** Everything that the picture depends on but the eye. */
export interface WheelLook {
  surface: Surface;
  raster: Raster | null;
  rulers: Rulers;
  places: readonly PlaceMark[];
  films: readonly ShownFilm[];
  filmSize: PatchSize | null;
  factor: number;
  isCut: boolean;
  /** The chosen place. */
  pointer: Vec3 | null;
}

export interface WheelScene {
  /** With so many pixels for each of the page's. */
  draw(look: WheelLook, camera: Camera, density: number): void;
  dispose(): void;
}

const POINTER_MM = 0.8;

/** A scene on a canvas by a context of its own. */
export function createWheelScene(canvas: HTMLCanvasElement, context: WebGL2RenderingContext): WheelScene {
  const renderer = new WebGLRenderer({ canvas, context, alpha: true });
  const scene = new Scene();
  const eye = new PerspectiveCamera(FIELD_OF_VIEW_DEG, 1, 1, 1000);
  eye.up.set(0, 0, 1);
  const shared: SharedUniforms = { factor: { value: 1 }, isCut: { value: false } };
  const pointer = pointerMesh();
  scene.add(pointer);
  let [tire, marks]: [Group, Group] = [new Group(), new Group()];
  let picture: DataTexture | null = null;
  let last: WheelLook | null = null;

  function rebuild(look: WheelLook): void {
    freeParts(tire);
    scene.remove(tire);
    tire = tireParts(shared, look.surface, picture, look.raster === null ? null : { rulers: look.rulers, raster: look.raster });
    scene.add(tire);
  }

  function remark(look: WheelLook): void {
    freeParts(marks);
    scene.remove(marks);
    marks = markParts(shared, look.surface, look.places, look.films, look.filmSize);
    scene.add(marks);
  }

  function take(look: WheelLook): void {
    [shared.factor.value, shared.isCut.value] = [look.factor, look.isCut];
    if (look.raster !== last?.raster) {
      picture?.dispose();
      picture = look.raster === null ? null : textureOf(look.raster);
    }
    const isMoved = look.surface !== last?.surface;
    const hadGround = last?.factor === 1;
    if (isMoved || look.raster !== last?.raster || look.isCut !== last.isCut || (look.factor === 1) !== hadGround) rebuild(look);
    if (isMoved || look.films !== last?.films || look.places !== last.places) remark(look);
    pointer.visible = look.pointer !== null;
    pointer.position.set(...(look.pointer ?? ([0, 0, 0] as Vec3)));
    last = look;
  }

  function draw(look: WheelLook, { orbit, width, height }: Camera, density: number): void {
    take(look);
    renderer.setPixelRatio(density);
    renderer.setSize(width, height, false);
    eye.aspect = width / height;
    eye.position.set(...eyeOf(orbit));
    eye.lookAt(...orbit.target);
    eye.updateProjectionMatrix();
    renderer.render(scene, eye);
  }

  function dispose(): void {
    freeParts(tire);
    freeParts(marks);
    picture?.dispose();
    pointer.geometry.dispose();
    pointer.material.dispose();
    renderer.dispose();
    // A page may hold few contexts, and would else hold this one until memory is collected.
    renderer.forceContextLoss();
  }

  return { draw, dispose };
}

function textureOf({ pixels, width, height }: Raster): DataTexture {
  const texture = new DataTexture(pixels, width, height);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The chosen place, seen through everything. */
function pointerMesh(): Mesh<SphereGeometry, MeshBasicMaterial> {
  const [red, green, blue] = POINTER;
  const mesh = new Mesh(new SphereGeometry(POINTER_MM, 16, 12), new MeshBasicMaterial({ depthTest: false, transparent: true }));
  mesh.material.color.setRGB(red / 255, green / 255, blue / 255, SRGBColorSpace);
  mesh.renderOrder = 9;
  return mesh;
}
