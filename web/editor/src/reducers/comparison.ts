/** What is wiped against what. */
import type { State } from "../state/document.ts";

/** The state that keeps the present fabric as "before". */
export function kept(state: State): State {
  return { ...state, comparison: { ...state.comparison, mode: "fabrics", before: state.fabric } };
}
