import { useEffect, useRef, useState } from "preact/hooks";
import { betweenViews, type Orbit, type ViewName } from "../../../../lib/tire/eye/orbit.ts";
import { eyeText, orbitOf, type Eye } from "../../../../lib/tire/view-address.ts";

const EASE_MS = 220;
/** Rest after a turn before it is told: what else shows the eye needn't follow every pixel. */
const REST_MS = 100;

export interface MovedEye {
  /** About a wheel of radius 1. */
  orbit: Orbit;
  /** At once. */
  set: (orbit: Orbit) => void;
  /** Over a moment, unless the reader wants no motion. */
  ease: (name: ViewName) => void;
}

/** Where the eye is, and how it gets elsewhere. Nothing runs while it rests. */
export function useEye(eye: Eye, onEye: (eye: Eye) => void): MovedEye {
  const [orbit, setOrbit] = useState(orbitOf(eye));
  const [frame, timer, told, teller] = [useRef(0), useRef(0), useRef(eyeText(eye)), useRef(onEye)];
  teller.current = onEye;
  const text = eyeText(eye);
  const still = (): void => {
    cancelAnimationFrame(frame.current);
    window.clearTimeout(timer.current);
  };
  useEffect(() => still, []);
  useEffect(() => {
    if (text === told.current) return;
    still();
    told.current = text;
    setOrbit(orbitOf(eye));
  }, [text]);

  function tell(to: Eye): void {
    timer.current = window.setTimeout(() => {
      told.current = eyeText(to);
      teller.current(to);
    }, REST_MS);
  }

  function ease(name: ViewName): void {
    still();
    tell(name);
    const to = orbitOf(name);
    if (window.matchMedia("(prefers-reduced-motion: reduce)").matches) {
      setOrbit(to);
      return;
    }
    const [from, begun] = [orbit, performance.now()];
    const step = (now: number): void => {
      const share = Math.min(1, Math.max(0, (now - begun) / EASE_MS));
      setOrbit(share === 1 ? to : betweenViews(from, to, share * share * (3 - 2 * share)));
      if (share < 1) frame.current = requestAnimationFrame(step);
    };
    frame.current = requestAnimationFrame(step);
  }

  function set(to: Orbit): void {
    still();
    tell(to);
    setOrbit(to);
  }

  return { orbit, set, ease };
}
