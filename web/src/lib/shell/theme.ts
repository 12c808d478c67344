/** Light or dark: as the system has it, unless the reader chose. */

type Theme = "light" | "dark";
/** What the reader chose; `system` follows the preference of the system. */
export type ThemeChoice = Theme | "system";

export const THEME_CHOICES: readonly ThemeChoice[] = ["system", "light", "dark"];

/** A stored choice; anything unknown follows the system. */
export function readChoice(stored: string | null): ThemeChoice {
  return THEME_CHOICES.find((choice) => choice === stored) ?? "system";
}

export function themeOf(choice: ThemeChoice, prefersDark: boolean): Theme {
  if (choice !== "system") return choice;
  return prefersDark ? "dark" : "light";
}
