/** Everything that can happen to the document. */
import type { BlockChange, FamilyName, Order, Region, Structure } from "loomlight-fabric";

import type { Comparison, Fabric, Notice, Scene, Tab } from "./document.ts";

/** Edits of the fabric; those with one `stroke` are one step of undo. */
export type FabricAction =
  | { readonly type: "fabric/open"; readonly fabric: Fabric }
  | { readonly type: "field/set"; readonly field: string; readonly value: unknown; readonly stroke?: string }
  | { readonly type: "fields/set"; readonly values: Readonly<Record<string, unknown>>; readonly stroke?: string }
  | { readonly type: "weave/choose"; readonly weave: string }
  | { readonly type: "artwork/read"; readonly as: "weaves" | "drawdown" }
  | { readonly type: "artwork/wefts"; readonly wefts: number }
  | { readonly type: "draft/crossing"; readonly pick: number; readonly end: number; readonly isUp: boolean; readonly stroke?: string }
  | { readonly type: "draft/thread"; readonly end: number; readonly shaft: number; readonly stroke?: string }
  | { readonly type: "draft/tie"; readonly treadle: number; readonly shaft: number; readonly isIn: boolean; readonly stroke?: string }
  | { readonly type: "draft/press"; readonly pick: number; readonly treadle: number; readonly stroke?: string }
  | { readonly type: "draft/lift"; readonly pick: number; readonly shaft: number; readonly isIn: boolean; readonly stroke?: string }
  | { readonly type: "draft/order"; readonly part: "threading" | "treadling"; readonly order: Order }
  | { readonly type: "draft/plan"; readonly kind: "liftplan" | "treadling" }
  | { readonly type: "draft/size"; readonly ends: number; readonly picks: number }
  | { readonly type: "draft/shafts"; readonly shafts: number; readonly treadles: number }
  | { readonly type: "draft/over" }
  | { readonly type: "draft/block"; readonly region: Region; readonly change: BlockChange }
  | { readonly type: "draft/paste"; readonly region: Region; readonly block: Structure }
  | { readonly type: "draft/fill"; readonly region: Region; readonly weave: string }
  | { readonly type: "draft/repeat"; readonly region: Region }
  | { readonly type: "colour/paint"; readonly family: FamilyName; readonly thread: number; readonly hex: string; readonly stroke?: string }
  | { readonly type: "colour/swap"; readonly family: FamilyName; readonly from: string; readonly to: string; readonly stroke?: string }
  | { readonly type: "colour/order"; readonly family: FamilyName; readonly hexes: readonly string[]; readonly stroke?: string };

export type HistoryAction = { readonly type: "history/undo" } | { readonly type: "history/redo" };

export type Action =
  | FabricAction
  | HistoryAction
  | { readonly type: "scene/set"; readonly scene: Partial<Scene> }
  | { readonly type: "comparison/set"; readonly comparison: Partial<Omit<Comparison, "before">> }
  | { readonly type: "comparison/keep" }
  | { readonly type: "comparison/exchange" }
  | { readonly type: "tab/show"; readonly tab: Tab }
  | { readonly type: "notice/add"; readonly kind: Notice["kind"]; readonly text: string; readonly offer?: Notice["offer"]; readonly topic?: Notice["topic"] }
  | { readonly type: "notice/clear"; readonly topic: NonNullable<Notice["topic"]> }
  | { readonly type: "notice/dismiss"; readonly id: number };
