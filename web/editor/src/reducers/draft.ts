/** Edits of the draft: crossings, threading, tie-up, treadling or liftplan, numbers of threads. */
import {
  loomOf,
  requireInterlacing,
  turnedOver,
  validateFields,
  withColoursInDraft,
  withCrossing,
  withLoom,
  withMember,
  withOnly,
  withPlanKind,
  withShafts,
  withSize,
  type Draft,
} from "loomlight-fabric";

import type { FabricAction } from "../state/actions.ts";
import { nameOf, type Fabric } from "../state/document.ts";

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
  const { weave: _weave, image: _image, ...kept } = own.fields;
  return { fields: validateFields({ ...kept, name, draft: draftFile(name) }), draft };
}

/** The file name of a draft that was made here. */
export function draftFile(name: string): string {
  const stem = name.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
  return `${stem === "" ? "draft" : stem}.wif`;
}

function edited(draft: Draft, action: DraftAction): Draft {
  const loom = loomOf(draft);
  switch (action.type) {
    case "draft/crossing":
      return withCrossing(draft, action.pick, action.end, action.isUp);
    case "draft/thread":
      return withLoom(draft, { ...loom, threading: withOnly(loom.threading, action.end, action.shaft) });
    case "draft/tie": {
      const tieup = withMember(loom.tieup ?? [], action.treadle, action.shaft, action.isIn);
      return withLoom(draft, { ...loom, tieup });
    }
    case "draft/press":
      return withLoom(draft, { ...loom, treadling: withOnly(loom.treadling ?? [], action.pick, action.treadle) });
    case "draft/lift": {
      const liftplan = withMember(loom.liftplan ?? [], action.pick, action.shaft, action.isIn);
      return withLoom(draft, { ...loom, liftplan });
    }
    case "draft/plan":
      return withPlanKind(draft, action.kind);
    case "draft/size":
      return withSize(draft, action.ends, action.picks);
    case "draft/shafts":
      return withShafts(draft, action.shafts, action.treadles);
    case "draft/over":
      return turnedOver(draft);
  }
}
