/** What the page begins with: the fabric of its address, else the one kept by the browser, else the session's. */
import { isInputError, loadDraft, messageOf } from "loomlight-fabric";

import type { Server } from "./api.ts";
import { fabricOfGallery, isEmbedded } from "./embedding.ts";
import { restore, restoreGood, setAside } from "./keeping/autosave.ts";
import type { Kept } from "./keeping/document_text.ts";
import { read } from "./keeping/slots.ts";
import { isDeadly } from "./keeping/starts.ts";
import { fabricOfLink } from "./link.ts";
import { firstState, type Fabric, type Notice, type State } from "./state/document.ts";
import { fabricFromJson, fabricText } from "./state/fabric_json.ts";

export interface Start {
  readonly state: State;
  readonly notices: readonly Omit<Notice, "id">[];
  /** Whether the state is one that the address or the browser gave back. */
  readonly isRestored: boolean;
}

/** Names the session's fabric that this window began with: a reload then goes on with what was kept. */
const OPENED = "loomlight.opened";

/** The state that the page begins with; what cannot be shown is set aside and told, and never in its way again. */
export async function startOf(server: Server | null): Promise<Start> {
  const notices: Omit<Notice, "id">[] = [];
  const tell = (text: string): number => notices.push({ kind: "fault", text, offer: "aside" });
  const named = galleryFabric(server);
  if (server !== null && server.host !== null) return { state: firstState(given(server)), notices, isRestored: false };
  if (isEmbedded(location.search)) {
    const fabric = (await fabricOfLink(location.hash).catch(() => null)) ?? named ?? given(server);
    return { state: firstState(fabric), notices, isRestored: false };
  }
  const deadly = isDeadly();
  const linked = await linkedFabric(deadly, tell);
  const kept = keptDocument(deadly, tell);
  if (linked !== null) {
    // After a reload what was kept is as new or newer, and has the light and the steps of undo too.
    const isSame = kept !== null && (kept.address === location.hash || fabricText(kept.fabric) === fabricText(linked));
    return { state: isSame ? stateOf(kept) : stateAfter(kept, linked), notices, isRestored: true };
  }
  if (named !== null) return { state: stateAfter(kept, named), notices, isRestored: false };
  const asked = server === null ? "" : server.session.fabric.name;
  // A fabric that the server was started for comes before the one that was kept from another.
  if (kept !== null && (server === null || openedBefore() === asked)) return { state: stateOf(kept), notices, isRestored: true };
  rememberOpened(asked);
  return { state: stateAfter(kept, given(server)), notices, isRestored: false };
}

/**
 * The state in place of one that turned out not to be shown: the last good one, else the session's fabric. The other
 * one is set aside.
 */
export function fallenBack(state: State, reason: string, server: Server | null): State {
  setAside(fabricText(state.fabric), reason);
  leaveAddress();
  const good = restoreGood();
  return good === null || fabricText(good.fabric) === fabricText(state.fabric) ? firstState(given(server)) : stateOf(good);
}

/** The sentence about what was set aside: of the address and of what was kept the same, as both are mostly one fabric. */
export function asideText(reason: string): string {
  return `The fabric that was here cannot be shown, and was set aside: ${reason} The last one that could is in its place.`;
}

async function linkedFabric(isSuspect: boolean, tell: (text: string) => void): Promise<Fabric | null> {
  const link = location.hash;
  try {
    const fabric = await fabricOfLink(link);
    if (fabric !== null && isSuspect) throw new Error(DEADLY);
    return fabric;
  } catch (error) {
    setAside(link, reasonOf(error));
    leaveAddress();
    const isRead = isInputError(error) || isSuspect;
    tell(
      isRead
        ? asideText(reasonOf(error))
        : "The page's address carries a fabric that cannot be read: it may have been cut. Another one is shown.",
    );
    return null;
  }
}

function keptDocument(isSuspect: boolean, tell: (text: string) => void): Kept | null {
  try {
    const kept = restore();
    if (kept !== null && isSuspect) throw new Error(DEADLY);
    return kept;
  } catch (error) {
    const text = read("document") ?? "";
    setAside(text, reasonOf(error));
    tell(asideText(reasonOf(error)));
    const good = restoreGood();
    return good !== null && isSuspect && text.startsWith(`{"fabric":${fabricText(good.fabric)},`) ? null : good;
  }
}

const DEADLY = "the page ended without a word each time it was shown.";

function reasonOf(error: unknown): string {
  const text = error instanceof SyntaxError ? "it is damaged" : messageOf(error);
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

function stateOf(kept: Kept): State {
  const { fabric, history, scene, comparison } = kept;
  return { ...firstState(fabric), history, scene, comparison };
}

/** A fabric that was asked for; undo goes back to what was kept before. */
function stateAfter(kept: Kept | null, fabric: Fabric): State {
  const first = firstState(fabric);
  if (kept === null || fabricText(kept.fabric) === fabricText(fabric)) return first;
  return { ...first, history: { past: [...kept.history.past, kept.fabric], future: [], stroke: null } };
}

function galleryFabric(server: Server | null): Fabric | null {
  try {
    return fabricOfGallery(location.search, server?.session ?? null);
  } catch {
    return null;
  }
}

function openedBefore(): string | null {
  try {
    return sessionStorage.getItem(OPENED);
  } catch {
    return null;
  }
}

function rememberOpened(name: string): void {
  try {
    sessionStorage.setItem(OPENED, name);
  } catch {
    // A browser that keeps nothing begins anew each time.
  }
}

function given(server: Server | null): Fabric {
  try {
    if (server !== null) return fabricFromJson({ ...server.session.fabric, artwork: server.session.artwork });
  } catch {
    // A server of another version: the page's own fabric serves.
  }
  const fields = { weave: "houndstooth 4", ends_per_cm: 11, picks_per_cm: 11, gap: 0.05 };
  return { fields, draft: loadDraft(fields) };
}

function leaveAddress(): void {
  history.replaceState(null, "", location.pathname + location.search);
}
