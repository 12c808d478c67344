/**
 * Colour maps, uniform by construction: straight or evenly sampled paths in Oklab, where equal distances look equal.
 *
 * Oklab after B. Ottosson (2020): linear sRGB -> cone response -> cube root -> lightness and two opponent axes.
 */

export type Rgb = readonly [red: number, green: number, blue: number];
type Oklab = readonly [lightness: number, a: number, b: number];

/** A colour for every value in [0, 1]. */
export type ColourMap = (share: number) => Rgb;

function encode(linear: number): number {
  const clamped = Math.min(1, Math.max(0, linear));
  const encoded = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * clamped ** (1 / 2.4) - 0.055;
  return Math.round(255 * encoded);
}

function decode(byte: number): number {
  const encoded = byte / 255;
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}

/** sRGB bytes of an Oklab colour, clipped to the gamut. */
export function rgbOfOklab([lightness, a, b]: Oklab): Rgb {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    encode(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** Oklab of sRGB bytes. */
export function oklabOfRgb([red, green, blue]: Rgb): Oklab {
  const [r, g, b] = [decode(red), decode(green), decode(blue)];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

const STEPS = 256;

/** Resamples a path so that neighbouring table entries are equally far apart in Oklab. */
function evenTable(path: (t: number) => Oklab): Rgb[] {
  const fine = Array.from({ length: 1025 }, (_, index) => path(index / 1024));
  const lengths = [0];
  for (let index = 1; index < fine.length; index += 1) {
    const [from, to] = [fine[index - 1] as Oklab, fine[index] as Oklab];
    lengths.push((lengths[index - 1] as number) + Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]));
  }
  const whole = lengths[lengths.length - 1] as number;
  let at = 0;
  return Array.from({ length: STEPS }, (_, step) => {
    const wanted = (whole * step) / (STEPS - 1);
    while (at < lengths.length - 1 && (lengths[at] as number) < wanted) at += 1;
    return rgbOfOklab(fine[at] as Oklab);
  });
}

function mapOf(table: Rgb[]): ColourMap {
  return (share) => {
    const clamped = Number.isFinite(share) ? Math.min(1, Math.max(0, share)) : 0;
    return table[Math.round(clamped * (STEPS - 1))] as Rgb;
  };
}

function polar(lightness: number, chroma: number, hue_deg: number): Oklab {
  const hue = (hue_deg * Math.PI) / 180;
  return [lightness, chroma * Math.cos(hue), chroma * Math.sin(hue)];
}

/** Dark violet over blue-green to light yellow, lightness rising all the way: for magnitudes from nothing to much. */
export const sequential: ColourMap = mapOf(evenTable((t) => polar(0.26 + 0.66 * t, 0.1 + 0.05 * t, 305 - 200 * t)));

/** Blue over near-white to red-brown, equally light at equal distance from the middle: for signed values. */
export const diverging: ColourMap = mapOf(
  evenTable((t) => {
    const side = Math.abs(2 * t - 1);
    return polar(0.96 - 0.5 * side, 0.15 * side, t < 0.5 ? 255 : 35);
  }),
);

/** The colour as CSS writes it. */
export function css([red, green, blue]: Rgb): string {
  return `rgb(${red} ${green} ${blue})`;
}

const [DARK, LIGHT]: [Rgb, Rgb] = [
  [0, 0, 0],
  [255, 255, 255],
];

/** The ratio of two colours' luminances after WCAG 2.2, from 1 to 21. */
export function contrast(a: Rgb, b: Rgb): number {
  const [low, high] = [luminance(a), luminance(b)].sort((one, other) => one - other) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** Black or white, whichever is read better on a colour. */
export function inkOn(ground: Rgb): Rgb {
  return contrast(ground, DARK) >= contrast(ground, LIGHT) ? DARK : LIGHT;
}

function luminance([red, green, blue]: Rgb): number {
  return 0.2126 * decode(red) + 0.7152 * decode(green) + 0.0722 * decode(blue);
}
