import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Orbit } from "../../../../lib/tire/eye/orbit.ts";
import type { WheelLook, WheelScene } from "./scene/wheel-scene.ts";

/** Pixels of the picture for each of the page's: few while it changes, and enough for smooth edges once it rests. Multisampling took three times as long. */
const [QUICK_DENSITY, SHARP_DENSITY] = [1, 2];
const REST_MS = 160;

/** `none`: the browser has no WebGL; `lost`: it had. */
export type SceneState = "loading" | "ready" | "none" | "lost";

export interface DrawnScene {
  state: SceneState;
  size: Size;
  /** Draws at once: what is drawn can be read only in the same turn. */
  draw: () => void;
}

interface Size {
  width: number;
  height: number;
}

/** Draws the look whenever it changes, once a frame at most, and once more when it rests; loads the library for it at first use, and frees it when left. */
export function useScene(canvas: { current: HTMLCanvasElement | null }, look: WheelLook, orbit: Orbit): DrawnScene {
  const [state, setState] = useState<SceneState>("loading");
  const scene = useRef<WheelScene | null>(null);
  const size = useSize(canvas);
  useEffect(() => open(canvas.current, setState, scene), []);
  const draw = (density: number): void => scene.current?.draw(look, { orbit, ...size }, density);
  useEffect(() => {
    if (state !== "ready") return undefined;
    const frame = requestAnimationFrame(() => draw(QUICK_DENSITY));
    const rest = window.setTimeout(() => draw(SHARP_DENSITY), REST_MS);
    return () => {
      cancelAnimationFrame(frame);
      window.clearTimeout(rest);
    };
  }, [state, ...Object.values(look), orbit, size.width, size.height]);
  return { state, size, draw: () => draw(SHARP_DENSITY) };
}

/** Makes the scene; what is returned frees it. */
function open(canvas: HTMLCanvasElement | null, tell: (state: SceneState) => void, scene: { current: WheelScene | null }): () => void {
  const context = canvas?.getContext("webgl2", { antialias: false, alpha: true }) ?? null;
  if (canvas === null || context === null) {
    tell("none");
    return () => undefined;
  }
  let isLeft = false;
  const lost = (event: Event): void => {
    event.preventDefault();
    tell("lost");
  };
  canvas.addEventListener("webglcontextlost", lost);
  void import("./scene/wheel-scene.ts").then(
    ({ createWheelScene }) => {
      if (isLeft || context.isContextLost()) return;
      scene.current = createWheelScene(canvas, context);
      tell("ready");
    },
    () => tell("none"),
  );
  return () => {
    isLeft = true;
    canvas.removeEventListener("webglcontextlost", lost);
    scene.current?.dispose();
    scene.current = null;
  };
}

function useSize(canvas: { current: HTMLCanvasElement | null }): Size {
  const [size, setSize] = useState<Size>({ width: 560, height: 400 });
  useLayoutEffect(() => {
    const element = canvas.current;
    if (element === null) return undefined;
    const measure = (): void => setSize({ width: Math.max(1, element.clientWidth), height: Math.max(1, element.clientHeight) });
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return size;
}
