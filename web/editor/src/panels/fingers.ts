/** Two fingers on a part of the page: how far they move together, and how far apart. */
import { useRef } from "preact/hooks";

interface Place {
  readonly x: number;
  readonly y: number;
}

interface Handlers {
  readonly onPointerDown: (event: PointerEvent) => void;
  readonly onPointerMove: (event: PointerEvent) => void;
  readonly onPointerUp: (event: PointerEvent) => void;
  readonly onPointerCancel: (event: PointerEvent) => void;
}

/**
 * Follows two fingers.
 *
 * @param onMove screen pixels to the right and down since the last call, the distance of the fingers over that at the
 *   start, and the cell that there was at the start.
 * @param cell screen pixels a cell.
 */
export function useFingers(onMove: (right: number, down: number, ratio: number, cell: number) => void, cell: number): Handlers {
  const places = useRef(new Map<number, Place>());
  const start = useRef({ apart: 1, cell });
  const leave = (event: PointerEvent): void => void places.current.delete(event.pointerId);
  const pair = (): readonly [Place, Place] | null => {
    const [a, b, ...more] = places.current.values();
    return a === undefined || b === undefined || more.length > 0 ? null : [a, b];
  };
  return {
    onPointerDown: (event) => {
      if (event.pointerType !== "touch") return;
      places.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const both = pair();
      if (both !== null) start.current = { apart: Math.max(apart(...both), 1), cell };
    },
    onPointerMove: (event) => {
      const before = places.current.get(event.pointerId);
      if (before === undefined) return;
      places.current.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const both = pair();
      // The middle of two moves by half of what one does.
      if (both !== null) onMove((event.clientX - before.x) / 2, (event.clientY - before.y) / 2, apart(...both) / start.current.apart, start.current.cell);
    },
    onPointerUp: leave,
    onPointerCancel: leave,
  };
}

const apart = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);
