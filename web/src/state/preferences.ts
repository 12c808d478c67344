/** What the reader chose for the page itself, kept in the browser. */

import { readChoice, themeOf, type ThemeChoice } from "../lib/shell/theme.ts";

const THEME = "strainsite.theme";
const KEYS = "strainsite.keys";

/** Puts the theme on the page, and keeps it right when the system changes its own. */
export function startTheme(): void {
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", showTheme);
  showTheme();
}

export function chosenTheme(): ThemeChoice {
  return readChoice(stored(THEME));
}

export function chooseTheme(choice: ThemeChoice): void {
  keep(THEME, choice);
  showTheme();
}

function showTheme(): void {
  const theme = themeOf(chosenTheme(), window.matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.classList.toggle("theme-dark", theme === "dark");
}

/** Whether keys without Control or Alt do something: some who speak to their computer turn that off. */
export function hasSingleKeys(): boolean {
  return stored(KEYS) !== "off";
}

export function setSingleKeys(isOn: boolean): void {
  keep(KEYS, isOn ? "on" : "off");
}

/** A browser may forbid storage: then nothing is kept. */
function stored(name: string): string | null {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

function keep(name: string, value: string): void {
  try {
    localStorage.setItem(name, value);
  } catch {
    return;
  }
}
