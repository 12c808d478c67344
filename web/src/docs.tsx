import { render } from "preact";
import * as api from "./api.ts";
import { answerTo } from "./state/loadable.ts";
import { startTheme } from "./state/preferences.ts";
import "./style/all.css";
import "./style/shell/reference.css";
import { ReferencePage } from "./views/reference/reference-page.tsx";

startTheme();
const root = document.getElementById("reference");
if (root !== null) {
  render(<ReferencePage described={{ status: "loading" }} />, root);
  const described = await answerTo(api.description());
  render(<ReferencePage described={described} />, root);
  // What the address names wasn't there when the browser looked for it.
  const named = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (named instanceof HTMLDetailsElement) named.open = true;
  named?.scrollIntoView();
}
