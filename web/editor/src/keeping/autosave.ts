/** Keeps the document in the browser, so that a closed page, a fault or a lost connection loses nothing. */
import type { State } from "../state/document.ts";
import { documentOf, documentText, type Kept } from "./document_text.ts";
import { read, write } from "./slots.ts";

/** Keeps the state, without its steps where there is no room for them; false where the browser keeps nothing. */
export function keep(state: State): boolean {
  const address = location.hash;
  return write("document", documentText(state, { address })) || write("document", documentText(state, { address, withHistory: false }));
}

/** Keeps a state that was shown without a fault, to come back to. */
export function keepGood(state: State): void {
  write("good", documentText(state, { withHistory: false }));
}

/**
 * What was kept last; null if nothing was.
 *
 * @throws Error it cannot be read.
 */
export function restore(): Kept | null {
  const text = read("document");
  return text === null ? null : documentOf(text);
}

/** The last document that was shown without a fault; null if there is none. */
export function restoreGood(): Kept | null {
  const text = read("good");
  try {
    return text === null ? null : documentOf(text);
  } catch {
    return null;
  }
}

/** Sets aside what could not be shown, and why; a later one takes its place. */
export function setAside(text: string, reason: string): void {
  write("aside", JSON.stringify({ reason, text }));
}

/** What was set aside, as a file. */
export function asideFile(): { name: string; content: string } | null {
  const content = read("aside");
  return content === null ? null : { name: "loomlight-set-aside.json", content };
}
