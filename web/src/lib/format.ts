/** Numbers and times as people read them. A value that does not exist is an em dash, never NaN. */

export const MISSING = "—";

const exists = (value: number | null | undefined): value is number => value != null && Number.isFinite(value);

/** Fixed decimals, true minus sign. */
export function fixed(value: number | null | undefined, decimals: number): string {
  if (!exists(value)) return MISSING;
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? `−${text}` : text;
}

/** Fixed decimals with a sign in front of what isn't negative, too: a difference. */
export function signed(value: number | null | undefined, decimals: number): string {
  const text = fixed(value, decimals);
  return exists(value) && !text.startsWith("−") ? `+${text}` : text;
}

/** A few significant digits without exponent where that stays readable. */
export function significant(value: number | null | undefined, digits = 3): string {
  if (!exists(value)) return MISSING;
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent < -4 || exponent > 8) return value.toExponential(digits - 1).replace("-", "−");
  return grouped(fixed(value, Math.max(0, digits - 1 - exponent)));
}

/** Thin spaces between groups of three digits before the decimal point. */
export function grouped(text: string): string {
  const [whole = "", fraction] = text.split(".");
  const spaced = whole.replace(/\d(?=(\d{3})+$)/g, "$&\u202f");
  return fraction === undefined ? spaced : `${spaced}.${fraction}`;
}

/** A rank among all ranks, as in sports: 2= where several share it. */
export function rankWords(rank: number, all: readonly { rank: number }[]): string {
  const sharing = all.filter((each) => each.rank === rank).length;
  return sharing > 1 ? `${rank}=` : `${rank}`;
}

export function integer(value: number | null | undefined): string {
  return exists(value) ? grouped(fixed(value, 0)) : MISSING;
}

/** A strain (dimensionless) in microstrain, without the unit. */
export function microstrain(strain: number | null | undefined): string {
  if (!exists(strain)) return MISSING;
  const micro = strain * 1e6;
  return Math.abs(micro) < 100 ? significant(micro, 3) : integer(micro);
}

/** A share as percent, without the sign. */
export function percent(share: number | null | undefined, decimals = 2): string {
  return exists(share) ? fixed(100 * share, decimals) : MISSING;
}

/** Seconds as a duration: 0.4 s, 12 s, 3 min 20 s, 2 h 05 min. */
export function duration(seconds: number | null | undefined): string {
  if (!exists(seconds) || seconds < 0) return MISSING;
  if (seconds < 9.95) return `${fixed(seconds, 1)} s`;
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  const minutes = Math.round(whole / 60);
  return `${Math.floor(minutes / 60)} h ${String(minutes % 60).padStart(2, "0")} min`;
}

/** Bytes in decimal units. */
export function bytes(count: number | null | undefined): string {
  if (!exists(count)) return MISSING;
  const units = ["B", "kB", "MB", "GB", "TB"];
  let value = count;
  let unit = 0;
  while (value >= 999.5 && unit < units.length - 1) {
    value /= 1000;
    unit += 1;
  }
  return `${unit === 0 ? value : significant(value, 3)} ${units[unit]}`;
}

/** A moment as the reader's clock shows it: time alone today, date and time before. */
export function moment(text: string | null, now: Date): string {
  const time = text === null ? Number.NaN : Date.parse(text);
  if (Number.isNaN(time)) return MISSING;
  const date = new Date(time);
  const pad = (value: number): string => String(value).padStart(2, "0");
  const clock = `${pad(date.getHours())}:${pad(date.getMinutes())}`;
  if (date.toDateString() === now.toDateString()) return clock;
  return `${date.getFullYear()}-${pad(date.getMonth() + 1)}-${pad(date.getDate())} ${clock}`;
}

/** How long ago a moment was, in one unit: just now, 5 min ago, 3 h ago, 2 days ago. */
export function ago(text: string | null, now: Date): string {
  const seconds = text === null ? Number.NaN : (now.getTime() - Date.parse(text)) / 1000;
  if (Number.isNaN(seconds)) return MISSING;
  if (seconds < 60) return "just now";
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  if (seconds < 86_400) return `${Math.floor(seconds / 3600)} h ago`;
  const days = Math.floor(seconds / 86_400);
  return days === 1 ? "yesterday" : `${days} days ago`;
}
