import { useState } from "preact/hooks";
import { formatRoute, homeRoute, type Route } from "../../lib/route.ts";
import { THEME_CHOICES, type ThemeChoice } from "../../lib/shell/theme.ts";
import { chooseTheme, chosenTheme } from "../../state/preferences.ts";

const HOME = formatRoute(homeRoute());
const FORCES = formatRoute({ view: "forces" });
const OWN = formatRoute({ view: "own" });

const THEME_NAMES: Record<ThemeChoice, string> = { system: "System", light: "Light", dark: "Dark" };

/** The name of the page, the way to a new study and to the service's description, colours and keys. */
export function Masthead({ route, onHelp }: { route: Route; onHelp: () => void }) {
  return (
    <header class="masthead">
      <a class="brand" href={HOME}>
        <span class="brand-name">strainsite</span>
        <span class="brand-line">where to glue strain films in a tire, and how sure that is</span>
      </a>
      <div class="masthead-end">
        <nav aria-label="Service">
          <a href={HOME} aria-current={route.view === "home" ? "page" : undefined}>
            New study
          </a>
          <a href={FORCES} aria-current={route.view === "forces" ? "page" : undefined}>
            Forces
          </a>
          <a href={OWN} aria-current={route.view === "own" ? "page" : undefined}>
            Your model
          </a>
          <a href="docs">API</a>
        </nav>
        <ThemeSwitch />
        <button type="button" class="help" aria-label="Keys and terms" title="Keys and terms (?)" onClick={onHelp}>
          ?
        </button>
      </div>
    </header>
  );
}

function ThemeSwitch() {
  const [choice, setChoice] = useState<ThemeChoice>(chosenTheme);
  function choose(value: string): void {
    const chosen = THEME_CHOICES.find((each) => each === value) ?? "system";
    chooseTheme(chosen);
    setChoice(chosen);
  }
  return (
    <select aria-label="Colours" title="Colours" value={choice} onChange={(event) => choose(event.currentTarget.value)}>
      {THEME_CHOICES.map((each) => (
        <option key={each} value={each}>
          {THEME_NAMES[each]}
        </option>
      ))}
    </select>
  );
}
