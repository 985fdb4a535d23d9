/** The next state of the document. */
import type { Action, FabricAction } from "../state/actions.ts";
import type { Fabric, State } from "../state/document.ts";
import { withColourEdit } from "./colours.ts";
import { kept } from "./comparison.ts";
import { withDraftEdit } from "./draft.ts";
import { withField, withWeave } from "./fields.ts";
import { redone, undone, withEdit } from "./history.ts";
import { withNotice, withoutNotice } from "./notices.ts";

/**
 * The state after an action.
 *
 * @throws InputError an edit that makes no cloth; the state stays as it is.
 */
export function reduce(state: State, action: Action): State {
  switch (action.type) {
    case "history/undo":
      return undone(state);
    case "history/redo":
      return redone(state);
    case "scene/set":
      return { ...state, scene: { ...state.scene, ...action.scene } };
    case "comparison/set":
      return { ...state, comparison: { ...state.comparison, ...action.comparison } };
    case "comparison/keep":
      return kept(state);
    case "comparison/exchange": {
      const { before } = state.comparison;
      if (before === null) return state;
      const exchanged = withEdit(state, before, null);
      return { ...exchanged, comparison: { ...state.comparison, before: state.fabric } };
    }
    case "tab/show":
      return { ...state, tab: action.tab };
    case "notice/add":
      return { ...state, notices: withNotice(state.notices, action.kind, action.text) };
    case "notice/dismiss":
      return { ...state, notices: withoutNotice(state.notices, action.id) };
    default:
      return withEdit(state, edited(state.fabric, action), "stroke" in action ? (action.stroke ?? null) : null);
  }
}

function edited(fabric: Fabric, action: FabricAction): Fabric {
  switch (action.type) {
    case "fabric/open":
      return action.fabric;
    case "field/set":
      return withField(fabric, action.field, action.value);
    case "weave/choose":
      return withWeave(fabric, action.weave);
    case "colour/paint":
    case "colour/swap":
    case "colour/order":
      return withColourEdit(fabric, action);
    default:
      return withDraftEdit(fabric, action);
  }
}
