/** Where the browser keeps what was made. A browser that keeps nothing, or no more, is no fault of the user's. */

/**
 * Names of what is kept: the document, the last one that was shown without a fault, one that could not be shown, the
 * piece for which yarn was reckoned, colour cards, and the user's own fabrics.
 */
export const SLOTS = {
  document: "loomlight.document.1",
  good: "loomlight.good.1",
  aside: "loomlight.aside.1",
  plan: "loomlight.plan.1",
  cards: "loomlight.cards.1",
  own: "loomlight.own.1",
} as const;
export type Slot = keyof typeof SLOTS;

/** What is kept in a slot; null where nothing is, or where the browser keeps nothing. */
export function read(slot: Slot): string | null {
  try {
    return localStorage.getItem(SLOTS[slot]);
  } catch {
    return null;
  }
}

/** Keeps a text; false where the browser does not. */
export function write(slot: Slot, text: string): boolean {
  try {
    localStorage.setItem(SLOTS[slot], text);
    return true;
  } catch {
    return false;
  }
}
