import type { Rgb } from "../../../../lib/chart/colour.ts";

/** The inner skin where the map ends; lighter than what isn't trusted. */
export const BARE: Rgb = [201, 207, 213];
export const OUTER: Rgb = [70, 84, 98];
export const WALL: Rgb = [92, 104, 117];
export const RIM: Rgb = [120, 132, 144];
export const GROUND: Rgb = [150, 128, 96];
/** Films, and the rim about each, so that one of both shows on every colour. */
export const FILM: Rgb = [20, 26, 34];
export const PLACE: Rgb = [255, 255, 255];
export const POINTER: Rgb = [226, 62, 36];
