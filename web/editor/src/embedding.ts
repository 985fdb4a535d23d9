/** What the page's address asks for: `?fabric=denim`, one of the gallery; `&embed=1`, the cloth alone. */
import type { Session } from "./api.ts";
import type { Fabric } from "./state/document.ts";
import { fabricFromJson } from "./state/fabric_json.ts";

/** The fabric of the gallery that an address names; null where it names none, or one that is not there. */
export function fabricOfGallery(search: string, session: Session | null): Fabric | null {
  const name = new URLSearchParams(search).get("fabric");
  const entry = session?.gallery.find(({ id }) => id === name);
  return entry === undefined ? null : fabricFromJson(entry);
}

/** Whether the page lies in a frame of another page, which shows the cloth alone and keeps nothing. */
export function isEmbedded(search: string): boolean {
  return new URLSearchParams(search).get("embed") === "1";
}
