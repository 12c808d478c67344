import { render } from "preact";
import { createActions } from "./state/actions.ts";
import { initialState } from "./state/app-state.ts";
import { startTheme } from "./state/preferences.ts";
import { createStore } from "./state/store.ts";
import "./style/all.css";
import { App } from "./views/app.tsx";

startTheme();
const root = document.getElementById("app");
if (root !== null) {
  const store = createStore(initialState(location.hash, Date.now()));
  const actions = createActions(store);
  const draw = (): void => render(<App state={store.get()} actions={actions} />, root);
  let scheduled = false;
  // Many changes in one turn, one drawing.
  store.subscribe(() => {
    if (scheduled) return;
    scheduled = true;
    queueMicrotask(() => {
      scheduled = false;
      draw();
    });
  });
  draw();
  actions.start();
}
