/** The selected rectangle of crossings, what was copied, and the edits of both: by keys, and for buttons. */
import { blockOf, regionAfter, within, type BlockChange, type Draft, type Region, type Structure } from "loomlight-fabric";
import { useState } from "preact/hooks";

import type { Action } from "../state/actions.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";

/** A crossing, from 0. */
export interface Crossing {
  readonly end: number;
  readonly pick: number;
}

export interface Selection {
  readonly region: Region | null;
  /** Whether dragging selects; else Shift and dragging does. */
  readonly isSelecting: boolean;
  readonly copied: Structure | null;
  /** Why the last edit was refused; empty where it was not. */
  readonly fault: string;
  readonly setSelecting: (isSelecting: boolean) => void;
  readonly select: (region: Region | null) => void;
  readonly copy: () => void;
  readonly cut: () => void;
  readonly paste: (cursor?: Crossing) => void;
  readonly change: (change: BlockChange) => void;
  readonly fillWithCopy: () => void;
  readonly fill: (weave: string) => void;
  readonly repeat: () => void;
  /** Whether a key was one of these edits. */
  readonly onKey: (event: KeyboardEvent, cursor: Crossing) => boolean;
}

/** The rectangle with two crossings at its corners. */
export function between(a: Crossing, b: Crossing): Region {
  const [firstEnd, firstPick] = [Math.min(a.end, b.end), Math.min(a.pick, b.pick)];
  return { firstEnd, firstPick, ends: Math.abs(a.end - b.end) + 1, picks: Math.abs(a.pick - b.pick) + 1 };
}

/** Copies live as long as the page: from one draft to another. */
let lastCopied: Structure | null = null;

const KEYS: Readonly<Record<string, BlockChange>> = { h: "mirror-ends", v: "mirror-picks", r: "turn", i: "face", Delete: "clear", Backspace: "clear" };
const ALT_KEYS: Readonly<Record<string, BlockChange>> = {
  ArrowLeft: "shift-left",
  ArrowRight: "shift-right",
  ArrowUp: "shift-up",
  ArrowDown: "shift-down",
};

export function useSelection(draft: Draft, dispatch: Dispatch): Selection {
  const [selected, setSelected] = useState<Region | null>(null);
  const [isSelecting, setSelecting] = useState(false);
  const [copied, setCopied] = useState(lastCopied);
  const [fault, setFault] = useState("");
  // Undo, or fewer threads, may leave less of it.
  const region = selected === null ? null : within(selected, draft);

  const select = (next: Region | null): void => {
    setSelected(next);
    setFault("");
  };
  const apply = (action: Action): boolean => {
    const refused = refusalOf(dispatch, action);
    setFault(refused ?? "");
    return refused === null;
  };
  const change = (kind: BlockChange): void => {
    if (region !== null && apply({ type: "draft/block", region, change: kind })) setSelected(regionAfter(region, kind));
  };
  const copy = (): void => {
    if (region !== null) setCopied((lastCopied = blockOf(draft, region)));
  };
  const cut = (): void => {
    copy();
    change("clear");
  };
  const paste = (cursor?: Crossing): void => {
    if (copied === null) return;
    const at = region === null ? (cursor ?? { end: 0, pick: 0 }) : { end: region.firstEnd, pick: region.firstPick };
    // What reaches over the edge is left out.
    const place = within({ firstEnd: at.end, firstPick: at.pick, ends: copied.ends, picks: copied.picks }, draft);
    if (place !== null && apply({ type: "draft/paste", region: place, block: copied })) setSelected(place);
  };
  const fillWithCopy = (): void => {
    if (region !== null && copied !== null) apply({ type: "draft/paste", region, block: copied });
  };
  const fill = (weave: string): void => {
    if (region !== null) apply({ type: "draft/fill", region, weave });
  };
  const repeat = (): void => {
    if (region !== null) apply({ type: "draft/repeat", region });
  };
  const onKey = (event: KeyboardEvent, cursor: Crossing): boolean => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.metaKey) {
      const edits: Readonly<Record<string, () => void>> = {
        a: () => select({ firstEnd: 0, firstPick: 0, ends: draft.ends, picks: draft.picks }),
        c: copy,
        x: cut,
        v: event.shiftKey ? fillWithCopy : () => paste(cursor),
      };
      edits[key]?.();
      return edits[key] !== undefined;
    }
    if (region === null) return false;
    const kind = event.altKey ? ALT_KEYS[key] : KEYS[key];
    if (kind !== undefined) change(kind);
    else if (key === "t" && !event.altKey) repeat();
    else if (key === "Escape") {
      // The next Escape closes the window.
      event.stopPropagation();
      select(null);
    } else return false;
    return true;
  };
  return { region, isSelecting, copied, fault, setSelecting, select, copy, cut, paste, change, fillWithCopy, fill, repeat, onKey };
}
