/** The next state of the document. */
import type { Action, FabricAction } from "../state/actions.ts";
import { TABS, type Fabric, type State } from "../state/document.ts";
import { usable } from "../state/usable.ts";
import { withReading, withWefts } from "./artwork.ts";
import { requireOneOf } from "./checks.ts";
import { withColourEdit } from "./colours.ts";
import { withDraftEdit } from "./draft.ts";
import { withFields, withWeave } from "./fields.ts";
import { redone, undone, withEdit } from "./history.ts";
import { withNotice, withoutNotice, withoutTopic } from "./notices.ts";
import { kept, withComparison, withScene } from "./scene.ts";

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
      return { ...state, scene: withScene(state.scene, action.scene) };
    case "comparison/set":
      return { ...state, comparison: withComparison(state.comparison, action.comparison) };
    case "comparison/keep":
      return kept(state);
    case "comparison/exchange": {
      const { before } = state.comparison;
      if (before === null) return state;
      const exchanged = withEdit(state, before, null);
      return { ...exchanged, comparison: { ...state.comparison, before: state.fabric } };
    }
    case "tab/show":
      return { ...state, tab: requireOneOf("tab", action.tab, TABS) };
    case "notice/add":
      return { ...state, notices: withNotice(state.notices, action) };
    case "notice/clear":
      return { ...state, notices: withoutTopic(state.notices, action.topic) };
    case "notice/dismiss":
      return { ...state, notices: withoutNotice(state.notices, action.id) };
    default:
      return withEdit(state, usable(edited(state.fabric, action)), "stroke" in action ? (action.stroke ?? null) : null);
  }
}

function edited(fabric: Fabric, action: FabricAction): Fabric {
  switch (action.type) {
    case "fabric/open":
      return action.fabric;
    case "field/set":
      return withFields(fabric, { [action.field]: action.value });
    case "fields/set":
      return withFields(fabric, action.values);
    case "weave/choose":
      return withWeave(fabric, action.weave);
    case "artwork/read":
      return withReading(fabric, action.as);
    case "artwork/wefts":
      return withWefts(fabric, action.wefts);
    case "colour/paint":
    case "colour/swap":
    case "colour/order":
      return withColourEdit(fabric, action);
    default:
      return withDraftEdit(fabric, action);
  }
}
