/** What a reader sees of a tire beside its layer, and how the address says so: a link shows what its sender saw. */

import { MOST_ELEVATION, VIEW_NAMES, viewOf, type Orbit, type ViewName } from "./eye/orbit.ts";
import type { SurfacePoint } from "./map/map-grid.ts";

/** Where the eye is: a view by its name, or an orbit about a wheel of radius 1, so that it holds for every tire. */
export type Eye = ViewName | Orbit;

export interface Sight {
  /** Place in the list of layouts of the one whose films are shown, or the one that the answer names; null for none. */
  layout: number | "answer" | null;
  /** Of the input; null at the means. */
  value: number | null;
  /** Ends of a scale that is kept, in the layer's own unit; null where the layer says them. */
  scale: readonly [low: number, high: number] | null;
  pin: SurfacePoint | null;
  /** Multiple of the displacement. */
  factor: number;
  isCut: boolean;
  eye: Eye;
}

export const MOST_FACTOR = 5;
/** Decimals of angles and of lengths in radii: finer than a pixel. */
const [ANGLE_DECIMALS, PIN_DECIMALS, RADII_DECIMALS] = [1, 3, 3];
const DIGITS = 6;

/** What is seen before the reader chose anything. */
export const PLAIN_SIGHT: Sight = { layout: "answer", value: null, scale: null, pin: null, factor: 1, isCut: true, eye: "start" };

/** Reads it from an address' query; what makes no sense there is at its default. */
export function readSight(values: URLSearchParams): Sight {
  const [value, factor] = [numberIn(values, "at"), numberIn(values, "factor")];
  const [low, high] = numbersIn(values, "scale", 2) ?? [];
  const [theta_deg, phi_deg] = numbersIn(values, "pin", 2) ?? [];
  return {
    layout: layoutIn(values),
    value,
    scale: low !== undefined && high !== undefined && low < high ? [low, high] : null,
    pin: theta_deg !== undefined && phi_deg !== undefined ? { theta_deg, phi_deg } : null,
    factor: factor !== null && factor >= 0 && factor <= MOST_FACTOR ? factor : 1,
    isCut: values.get("cut") !== "no",
    eye: eyeIn(values),
  };
}

/** Writes what isn't at its default. */
export function writeSight({ layout, value, scale, pin, factor, isCut, eye }: Sight, values: URLSearchParams): void {
  if (layout !== "answer") values.set("layout", layout === null ? "none" : String(layout + 1));
  if (value !== null) values.set("at", digits(value));
  if (scale !== null) values.set("scale", scale.map(digits).join());
  if (pin !== null) values.set("pin", [pin.theta_deg, pin.phi_deg].map((angle) => rounded(angle, PIN_DECIMALS)).join());
  if (factor !== 1) values.set("factor", digits(factor));
  if (!isCut) values.set("cut", "no");
  if (eye !== "start") values.set("eye", eyeText(eye));
}

/** It as one text: two that are written alike are one. */
export function sightText(sight: Sight): string {
  const values = new URLSearchParams();
  writeSight(sight, values);
  return values.toString();
}

/** `side`, or azimuth, elevation, distance and height of what is looked at. */
export function eyeText(eye: Eye): string {
  if (typeof eye === "string") return eye;
  const { azimuth_deg, elevation_deg, distance_mm, target } = eye;
  return [
    rounded(wrapped(azimuth_deg), ANGLE_DECIMALS),
    rounded(elevation_deg, ANGLE_DECIMALS),
    rounded(distance_mm, RADII_DECIMALS),
    rounded(target[2], RADII_DECIMALS),
  ].join();
}

/** The orbit about a wheel of radius 1. */
export function orbitOf(eye: Eye): Orbit {
  return typeof eye === "string" ? viewOf(eye, 1) : eye;
}

function layoutIn(values: URLSearchParams): Sight["layout"] {
  if (values.get("layout") === "none") return null;
  const place = numberIn(values, "layout");
  return place !== null && Number.isInteger(place) && place > 0 ? place - 1 : "answer";
}

function eyeIn(values: URLSearchParams): Eye {
  const name = VIEW_NAMES.find((view) => view === values.get("eye"));
  if (name !== undefined) return name;
  const [azimuth_deg, elevation_deg, distance_mm, height] = numbersIn(values, "eye", 4) ?? [];
  if (azimuth_deg === undefined || elevation_deg === undefined || distance_mm === undefined || height === undefined) return "start";
  if (Math.abs(elevation_deg) > MOST_ELEVATION || distance_mm <= 0) return "start";
  return { azimuth_deg, elevation_deg, distance_mm, target: [0, 0, height] };
}

function numberIn(values: URLSearchParams, name: string): number | null {
  return numbersIn(values, name, 1)?.[0] ?? null;
}

/** So many finite numbers with commas between them; null for anything else. */
function numbersIn(values: URLSearchParams, name: string, count: number): number[] | null {
  const parts = (values.get(name) ?? "").split(",");
  const numbers = parts.map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}

function wrapped(angle_deg: number): number {
  return ((((angle_deg + 180) % 360) + 360) % 360) - 180;
}

function rounded(value: number, decimals: number): string {
  return String(Number(value.toFixed(decimals)));
}

function digits(value: number): string {
  return String(asWritten(value));
}

/** A value with the digits that an address has of it. */
export function asWritten(value: number): number {
  return Number(value.toPrecision(DIGITS));
}
