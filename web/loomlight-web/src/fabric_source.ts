/** Fabrics of a page without Python: from fields, from the text of a fabric file, from a weave's name or a WIF. */
import { loadDraft, readToml, type Draft, type FabricFields, type Files, type Warn } from "loomlight-fabric";

/** Fields of a fabric, with the keys of a fabric file, and the draft that they name. */
export interface Fabric {
  readonly fields: FabricFields;
  readonly draft: Draft;
}

/**
 * The fabric of fields, of the text of a fabric file, or of a weave's name such as "twill 3/1".
 *
 * @param files drafts that the fields name, by their names: { "scarf.wif": bytes }.
 * @throws InputError fields or a text that make no fabric: one sentence.
 */
export function fabricOf(source: FabricFields | string, files: Files = {}, warn?: Warn): Fabric {
  const fields =
    typeof source !== "string" ? source : source.includes("=") ? readToml(source) : { weave: source.trim() };
  return { fields, draft: loadDraft(fields, files, warn) };
}
