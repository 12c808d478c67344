import { useRef } from "preact/hooks";

/** Pixels that still count as a click. */
const STILL = 4;

interface DragListener {
  turn: (right: number, down: number) => void;
  /** Over a pixel, or null when the pointer has left. */
  hover: (x: number | null, y: number) => void;
  click: (x: number, y: number) => void;
}

/** A pointer that turns when pressed, and points when not. */
export function useDrag({ turn, hover, click }: DragListener) {
  const pressed = useRef<{ x: number; y: number; way: number } | null>(null);
  const at = (event: PointerEvent): [number, number] => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      const [x, y] = at(event);
      pressed.current = { x, y, way: 0 };
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    },
    onPointerMove: (event: PointerEvent) => {
      const [x, y] = at(event);
      const from = pressed.current;
      if (from === null) return hover(x, y);
      pressed.current = { x, y, way: from.way + Math.abs(x - from.x) + Math.abs(y - from.y) };
      turn(x - from.x, y - from.y);
    },
    onPointerUp: (event: PointerEvent) => {
      if (pressed.current !== null && pressed.current.way <= STILL) click(...at(event));
      pressed.current = null;
    },
    onPointerCancel: () => {
      pressed.current = null;
    },
    onPointerLeave: () => hover(null, 0),
  };
}
