/** Undo and redo over fabrics. */
import type { Fabric, State } from "../state/document.ts";

/** Steps that can be undone. */
const DEEPEST = 200;

/** The state with an edited fabric; edits of one stroke are one step. */
export function withEdit(state: State, fabric: Fabric, stroke: string | null): State {
  if (fabric === state.fabric) return state;
  const { past, stroke: before } = state.history;
  const goesOn = stroke !== null && stroke === before;
  const kept = goesOn ? past : [...past, state.fabric].slice(-DEEPEST);
  return { ...state, fabric, history: { past: kept, future: [], stroke } };
}

/** The state one step back; the same where there is none. */
export function undone(state: State): State {
  const { past, future } = state.history;
  const fabric = past.at(-1);
  if (fabric === undefined) return state;
  return { ...state, fabric, history: { past: past.slice(0, -1), future: [state.fabric, ...future], stroke: null } };
}

/** The state one step forward; the same where there is none. */
export function redone(state: State): State {
  const { past, future } = state.history;
  const [fabric, ...rest] = future;
  if (fabric === undefined) return state;
  return { ...state, fabric, history: { past: [...past, state.fabric], future: rest, stroke: null } };
}
