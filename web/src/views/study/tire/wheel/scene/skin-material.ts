import { Color, DoubleSide, ShaderMaterial, type DataTexture, type IUniform } from "three";
import type { Rgb } from "../../../../../lib/chart/colour.ts";

/** What all parts of the picture share. */
export interface SharedUniforms {
  /** Multiple of the displacement. */
  factor: IUniform<number>;
  /** Whether what lies beyond the middle plane, on the side of y < 0, is cut away. */
  isCut: IUniform<boolean>;
}

const VERTEX = `
attribute vec3 moved;
uniform float factor;
varying vec3 place;
varying vec3 facing;
varying vec3 sight;
varying vec2 onMap;
void main() {
  place = position + factor * moved;
  vec4 seen = modelViewMatrix * vec4(place, 1.0);
  facing = normalMatrix * normal;
  sight = -seen.xyz;
  onMap = uv;
  gl_Position = projectionMatrix * seen;
}`;

const FRAGMENT = `
uniform vec3 colour;
uniform float opacity;
uniform bool isCut;
uniform bool isMapped;
uniform sampler2D picture;
varying vec3 place;
varying vec3 facing;
varying vec3 sight;
varying vec2 onMap;
void main() {
  if (isCut && place.y < 0.0) discard;
  vec3 base = colour;
  bool isInside = all(greaterThanEqual(onMap, vec2(0.0))) && all(lessThanEqual(onMap, vec2(1.0)));
  if (isMapped && isInside) base = texture2D(picture, onMap).rgb;
  float light = 0.68 + 0.32 * abs(dot(normalize(facing), normalize(sight)));
  gl_FragColor = vec4(base * light, opacity);
}`;

interface Look {
  colour: Rgb;
  opacity?: number;
  picture?: DataTexture | null;
  /** Films and marks stay whole when the tire is cut. */
  staysWhole?: boolean;
}

/** One colour, or a picture where the map reaches, lit from the eye; the displacement is added on the way. */
export function skinMaterial(shared: SharedUniforms, { colour, opacity = 1, picture = null, staysWhole = false }: Look): ShaderMaterial {
  const isClear = opacity < 1;
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    transparent: isClear,
    depthWrite: !isClear,
    uniforms: {
      factor: shared.factor,
      isCut: staysWhole ? { value: false } : shared.isCut,
      colour: { value: new Color(...(colour.map((byte) => byte / 255) as [number, number, number])) },
      opacity: { value: opacity },
      isMapped: { value: picture !== null },
      picture: { value: picture },
    },
  });
}
