/** Keys that work anywhere on the page. */

import { SECTIONS, type Route, type Section } from "../../route.ts";

/** What a key does. */
type KeyAction = { does: "help" } | { does: "open"; section: Section };

/** What is pressed, and where. */
interface Pressed {
  key: string;
  /** Control, Alt or the system's key is held. */
  isModified: boolean;
  /** In a field that takes text. */
  isTyping: boolean;
}

/** `?` lists the keys, 1 to 6 open the sections of a study; null for any other key. */
export function actionOf({ key, isModified, isTyping }: Pressed, route: Route): KeyAction | null {
  if (isModified || isTyping) return null;
  if (key === "?") return { does: "help" };
  const section = route.view === "study" && /^[1-9]$/.test(key) ? SECTIONS[Number(key) - 1] : undefined;
  return section === undefined ? null : { does: "open", section };
}

/** For the list of keys. */
export const KEYS: readonly { keys: string; does: string }[] = [
  { keys: "?", does: "this list, and all terms" },
  { keys: "1 to 6", does: "answer, tire, layouts, indices, trade, run of a study" },
  { keys: "← → ↑ ↓", does: "in a study's links and in the lists: to the next link, entry or button" },
  { keys: "Tab, Enter", does: "from the start of the page: skip to the section" },
  { keys: "← →", does: "on the wheel: turn it by a degree; with Shift by ten" },
  { keys: "W", does: "on the wheel: turn it to its worst angle" },
  { keys: "← → ↑ ↓", does: "on the map: read the next cell; on the tire: turn it" },
  { keys: "1 to 4, + −, C, R", does: "on the tire: front, side, top, section; nearer, farther; cut it open; as it was" },
];
