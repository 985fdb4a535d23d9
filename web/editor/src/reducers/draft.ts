/** Edits of the draft: crossings, threading, tie-up, treadling or liftplan, numbers of threads. */
import {
  BLOCK_CHANGES,
  InputError,
  loadDraft,
  loomOf,
  MAXIMUM_THREADS,
  ordered,
  ORDERS,
  requireInterlacing,
  turnedOver,
  validateFields,
  withBlockChange,
  withColoursInDraft,
  withCrossing,
  withFill,
  withLoom,
  withMember,
  withOnly,
  withPlanKind,
  withRepeat,
  withShafts,
  withSize,
  withoutArtwork,
  type Draft,
  type Region,
  type Structure,
} from "loomlight-fabric";

import type { FabricAction } from "../state/actions.ts";
import { nameOf, type Fabric } from "../state/document.ts";
import { tableOf } from "../state/json_table.ts";
import { requireOneOf, requireWhole, shown } from "./checks.ts";

type DraftAction = Extract<FabricAction, { type: `draft/${string}` }>;

/**
 * The fabric with an edited draft: from then on the draft is a file of its own, which holds the threads' colours.
 *
 * @throws InputError a draft in which nothing interlaces, or with too few threads.
 */
export function withDraftEdit(fabric: Fabric, action: DraftAction): Fabric {
  const name = nameOf(fabric);
  const own = withColoursInDraft(fabric.fields, fabric.draft);
  const before = own.draft.loom === null ? { ...own.draft, loom: loomOf(own.draft) } : own.draft;
  const draft = { ...edited(before, action), name };
  requireInterlacing(draft);
  const { weave: _weave, ...kept } = withoutArtwork(own.fields, fabric.draft);
  return { fields: validateFields({ ...kept, name, draft: draftFile(name) }), draft };
}

/** The file name of a draft that was made here. */
export function draftFile(name: string): string {
  const stem = name.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
  return `${stem === "" ? "draft" : stem}.wif`;
}

function edited(draft: Draft, action: DraftAction): Draft {
  const loom = loomOf(draft);
  const endOf = (end: number): number => requireWhole("end", end, 0, draft.ends - 1);
  const pickOf = (pick: number): number => requireWhole("pick", pick, 0, draft.picks - 1);
  const shaftOf = (shaft: number): number => requireWhole("shaft", shaft, 1, loom.shafts);
  switch (action.type) {
    case "draft/crossing":
      return withCrossing(draft, pickOf(action.pick), endOf(action.end), action.isUp === true);
    case "draft/thread":
      return withLoom(draft, { ...loom, threading: withOnly(loom.threading, endOf(action.end), shaftOf(action.shaft)) });
    case "draft/tie": {
      const treadle = requireWhole("treadle", action.treadle, 0, loom.treadles - 1);
      const tieup = withMember(loom.tieup ?? [], treadle, shaftOf(action.shaft), action.isIn === true);
      return withLoom(draft, { ...loom, tieup });
    }
    case "draft/press": {
      const treadle = requireWhole("treadle", action.treadle, 1, loom.treadles);
      return withLoom(draft, { ...loom, treadling: withOnly(loom.treadling ?? [], pickOf(action.pick), treadle) });
    }
    case "draft/lift": {
      if (loom.liftplan === null || loom.treadling !== null) throw new InputError("The draft has no lift plan: choose it as its plan.");
      const liftplan = withMember(loom.liftplan, pickOf(action.pick), shaftOf(action.shaft), action.isIn === true);
      return withLoom(draft, { ...loom, liftplan });
    }
    case "draft/order": {
      const order = requireOneOf("order", action.order, ORDERS);
      if (requireOneOf("part", action.part, ["threading", "treadling"] as const) === "threading")
        return withLoom(draft, { ...loom, threading: ordered(order, draft.ends, loom.shafts).map((shaft) => [shaft]) });
      if (loom.treadling === null) throw new InputError("The draft has no treadles: choose tie-up and treadling as its plan.");
      return withLoom(draft, { ...loom, treadling: ordered(order, draft.picks, loom.treadles).map((treadle) => [treadle]) });
    }
    case "draft/plan":
      return withPlanKind(draft, requireOneOf("plan", action.kind, ["liftplan", "treadling"] as const));
    case "draft/size":
      return withSize(
        draft,
        requireWhole("ends", action.ends, 2, MAXIMUM_THREADS),
        requireWhole("picks", action.picks, 2, MAXIMUM_THREADS),
      );
    case "draft/shafts":
      return withShafts(
        draft,
        requireWhole("shafts", action.shafts, 1, MAXIMUM_THREADS),
        requireWhole("treadles", action.treadles, 0, MAXIMUM_THREADS),
      );
    case "draft/over":
      return turnedOver(draft);
    case "draft/block":
      return withBlockChange(draft, regionIn(draft, action.region), requireOneOf("change", action.change, BLOCK_CHANGES));
    case "draft/paste":
      return withFill(draft, regionIn(draft, action.region), blockFrom(action.block), "region");
    case "draft/fill": {
      if (typeof action.weave !== "string") throw new InputError('The weave has no name: write "twill 3/1".');
      return withFill(draft, regionIn(draft, action.region), loadDraft({ weave: action.weave }), "draft");
    }
    case "draft/repeat":
      return withRepeat(draft, regionIn(draft, action.region));
    default:
      throw new InputError(`${shown((action as { readonly type: unknown }).type)} is no edit.`);
  }
}

/** A region that lies in the draft. */
function regionIn(draft: Draft, given: unknown): Region {
  const { firstEnd, firstPick, ends, picks } = tableOf(given);
  const [end, pick] = [requireWhole("first end", firstEnd, 0, draft.ends - 1), requireWhole("first pick", firstPick, 0, draft.picks - 1)];
  return {
    firstEnd: end,
    firstPick: pick,
    ends: requireWhole("ends of the selection", ends, 1, draft.ends - end),
    picks: requireWhole("picks of the selection", picks, 1, draft.picks - pick),
  };
}

/** Crossings that were copied. */
function blockFrom(given: unknown): Structure {
  const { ends, picks, drawdown } = tableOf(given);
  const [across, along] = [requireWhole("copied ends", ends, 1, MAXIMUM_THREADS), requireWhole("copied picks", picks, 1, MAXIMUM_THREADS)];
  if (!(drawdown instanceof Uint8Array) || drawdown.length !== across * along)
    throw new InputError(`A copy of ${across} ends and ${along} picks has ${across * along} crossings: copy it again.`);
  return { ends: across, picks: along, drawdown };
}
