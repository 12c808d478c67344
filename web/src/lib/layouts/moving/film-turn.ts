/**
 * A function of the angle from the contact with a sample each degree from -180, as the service has it: between samples the cubic through the values and slopes at
 * both ends; slopes are central differences of fourth order. The operations and their order are the service's, so that sums differ by nothing but the last digit.
 */

const DEGREES = 360;

export interface Turn {
  samples: readonly number[];
  /** 1/degree. */
  slopes: readonly number[];
}

/** Through 360 samples. */
export function turnOf(samples: readonly number[]): Turn {
  const at = (i: number, by: number): number => samples[(i + by) % DEGREES] ?? 0;
  const slopes = samples.map((_, i) => {
    const near = at(i, 1) - at(i, DEGREES - 1);
    const far = at(i, 2) - at(i, DEGREES - 2);
    return (8 * near - far) / 12;
  });
  return { samples, slopes };
}

/** Value and derivative at an angle, degrees. */
export function curveAt({ samples, slopes }: Turn, angle_deg: number): { value: number; slope: number } {
  const place = wrapped(angle_deg + 180);
  const i = Math.floor(place) % DEGREES;
  const j = (i + 1) % DEGREES;
  const t = place - Math.floor(place);
  const s = 1 - t;
  const [a = 0, b = 0, p = 0, q = 0] = [samples[i], samples[j], slopes[i], slopes[j]];
  const rise = 6 * s * t;
  return {
    value: s * s * (1 + 2 * t) * a + t * t * (1 + 2 * s) * b + s * s * t * p + -t * t * s * q,
    slope: -rise * a + rise * b + s * (s - 2 * t) * p + t * (t - 2 * s) * q,
  };
}

/** The same angle from 0 to 360 degrees. */
export function wrapped(angle_deg: number): number {
  const rest = angle_deg % DEGREES;
  return rest < 0 ? rest + DEGREES : rest;
}
