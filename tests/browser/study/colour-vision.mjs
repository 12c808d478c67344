// How far apart colours look, to those who see green and to those who don't.

/** Linear sRGB as somebody without the green cones sees it: Machado, Oliveira and Fernandes (2009), severity 1. */
const DEUTERANOPIA = [
  [0.367322, 0.860646, -0.227968],
  [0.280085, 0.672501, 0.047413],
  [-0.01182, 0.04294, 0.968881],
];
/** Linear sRGB to responses of the cones, and their cube roots to lightness and two opponent axes: Oklab, B. Ottosson (2020). */
const CONES = [
  [0.4122214708, 0.5363325363, 0.0514459929],
  [0.2119034982, 0.6806995451, 0.1073969566],
  [0.0883024619, 0.2817188376, 0.6299787005],
];
const OPPONENT = [
  [0.2104542553, 0.793617785, -0.0040720468],
  [1.9779984951, -2.428592205, 0.4505937099],
  [0.0259040371, 0.7827717662, -0.808675766],
];

const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, factor, k) => sum + factor * vector[k], 0));

function linear(byte) {
  const share = byte / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

/** Oklab of a colour of three bytes. */
export function oklab(rgb, isDeuteranope = false) {
  const seen = isDeuteranope ? times(DEUTERANOPIA, rgb.map(linear)) : rgb.map(linear);
  return times(
    OPPONENT,
    times(
      CONES,
      seen.map((value) => Math.min(1, Math.max(0, value))),
    ).map(Math.cbrt),
  );
}

/** The least distance in Oklab between any two colours that a deuteranope sees, with those two. */
export function nearest(colours) {
  const seen = colours.map((rgb) => oklab(rgb, true));
  const pairs = colours.flatMap((one, k) =>
    colours.slice(0, k).map((other, j) => ({ pair: [other, one], distance: Math.hypot(...seen[k].map((value, i) => value - seen[j][i])) })),
  );
  return pairs.reduce((least, each) => (each.distance < least.distance ? each : least));
}
