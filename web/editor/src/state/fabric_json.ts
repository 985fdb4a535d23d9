/** Fabrics as JSON: of the server, of the page's address, and of what the browser keeps. */
import {
  artworkFromJson,
  artworkToJson,
  draftFromJson,
  draftToJson,
  InputError,
  loadDraft,
  validateFields,
  weaveArtwork,
  type Artwork,
  type ArtworkJson,
  type Draft,
  type DraftJson,
} from "loomlight-fabric";

import type { Fabric } from "./document.ts";
import { hasWeaves, isArtwork, isNamed, nameOf } from "./document.ts";
import { usable } from "./usable.ts";

/** A fabric; a draft that the fields name by a weave's name, or that an artwork is woven to, may be left out. */
export interface StoredFabric {
  readonly fields: Record<string, unknown>;
  readonly draft?: DraftJson | null;
  readonly artwork?: ArtworkJson | null;
}

/**
 * The fabric of its JSON.
 *
 * @throws InputError fields or a draft that cannot be, or that no panel could show.
 */
export function fabricFromJson(json: unknown): Fabric {
  if (typeof json !== "object" || json === null) throw new InputError("This is no fabric.");
  const { fields: given, draft: drawn, artwork: pictured } = json as Partial<StoredFabric>;
  const fields = validateFields(given);
  const artwork = pictured == null || fields.image === undefined ? null : artworkFromJson(pictured);
  const draftOf = (): Draft => {
    // A named weave knows the roles of its colours better than its JSON.
    if (fields.weave !== undefined) return loadDraft(fields);
    if (drawn != null) return draftFromJson(drawn);
    return artwork !== null && hasWeaves(fields) ? weaveArtwork(artwork, fields, fields.image!).draft : loadDraft(fields);
  };
  return usable({ fields, draft: draftOf(), ...(artwork === null ? {} : { artwork }) });
}

const textOfFabric = new WeakMap<Fabric, string>();

/** The fabric's JSON as text, which is made once. */
export function fabricText(fabric: Fabric): string {
  let text = textOfFabric.get(fabric);
  if (text === undefined) {
    text = JSON.stringify(fabricToJson(fabric));
    textOfFabric.set(fabric, text);
  }
  return text;
}

/** The fabric as JSON, as short as it can be. */
export function fabricToJson(fabric: Fabric): StoredFabric {
  const fields = { ...fabric.fields } as Record<string, unknown>;
  if (isNamed(fabric)) return { fields };
  const artwork = fabric.artwork === undefined ? {} : { artwork: jsonOf(fabric.artwork) };
  return isArtwork(fabric) ? { fields, ...artwork } : { fields, draft: draftToJson(fabric.draft), ...artwork };
}

const jsonOfArtwork = new WeakMap<Artwork, ArtworkJson>();

/** The artwork's JSON, which is made once: edits leave the picture as it is. */
function jsonOf(artwork: Artwork): ArtworkJson {
  const json = jsonOfArtwork.get(artwork) ?? artworkToJson(artwork);
  jsonOfArtwork.set(artwork, json);
  return json;
}

/** The fabric as the server takes it, with its whole draft. */
export function fabricForServer(fabric: Fabric): { name: string; fields: Record<string, unknown>; draft: DraftJson } {
  return { name: nameOf(fabric), fields: { ...fabric.fields }, draft: draftToJson(fabric.draft) };
}
