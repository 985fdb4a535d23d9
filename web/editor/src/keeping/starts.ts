/**
 * Counts starts of the page that came to no end: a document that kills its tab each time would do so for ever.
 *
 * A tab that is closed or reloaded says so; one that dies does not.
 */

const PLACE = "loomlight.starts";
/** So many tabs died while they showed the document. */
const MAX = 2;

/** Counts this start; true if the last ones died. */
export function isDeadly(): boolean {
  try {
    const died = Number(sessionStorage.getItem(PLACE) ?? 0);
    sessionStorage.setItem(PLACE, String(died >= MAX ? 1 : died + 1));
    addEventListener("pagehide", survived);
    return died >= MAX;
  } catch {
    return false;
  }
}

/** The page lives, or ends as it should. */
export function survived(): void {
  try {
    sessionStorage.removeItem(PLACE);
  } catch {
    // A browser that keeps nothing counts nothing.
  }
}
