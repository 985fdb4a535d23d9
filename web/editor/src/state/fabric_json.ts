/** Fabrics as JSON: of the server, of the page's address, and of what the browser keeps. */
import { draftFromJson, draftToJson, InputError, loadDraft, validateFields, type DraftJson } from "loomlight-fabric";

import type { Fabric } from "./document.ts";
import { isNamed, nameOf } from "./document.ts";
import { usable } from "./usable.ts";

/** A fabric; a draft that the fields name by a weave's name may be left out. */
export interface StoredFabric {
  readonly fields: Record<string, unknown>;
  readonly draft?: DraftJson | null;
}

/**
 * The fabric of its JSON.
 *
 * @throws InputError fields or a draft that cannot be, or that no panel could show.
 */
export function fabricFromJson(json: unknown): Fabric {
  if (typeof json !== "object" || json === null) throw new InputError("This is no fabric.");
  const { fields: given, draft: drawn } = json as Partial<StoredFabric>;
  const fields = validateFields(given);
  // A named weave knows the roles of its colours better than its JSON.
  const draft = fields.weave !== undefined || drawn == null ? loadDraft(fields) : draftFromJson(drawn);
  return usable({ fields, draft });
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
  return isNamed(fabric) ? { fields } : { fields, draft: draftToJson(fabric.draft) };
}

/** The fabric as the server takes it, with its whole draft. */
export function fabricForServer(fabric: Fabric): { name: string; fields: Record<string, unknown>; draft: DraftJson } {
  return { name: nameOf(fabric), fields: { ...fabric.fields }, draft: draftToJson(fabric.draft) };
}
