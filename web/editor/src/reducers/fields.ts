/** Fields of the fabric, and the weave that they name. */
import { InputError, loadDraft, validateFields, type FabricFields } from "loomlight-fabric";

import type { Fabric } from "../state/document.ts";
import { rewoven } from "./artwork.ts";

/** Fields that say the same thing twice: a new value of one takes the place of the others. A count beside a gap weighs. */
const INSTEAD_OF: Readonly<Partial<Record<string, readonly string[]>>> = {
  ends_per_cm: ["epi"],
  epi: ["ends_per_cm"],
  picks_per_cm: ["ppi"],
  ppi: ["picks_per_cm"],
  "warp.gap": ["warp.width_mm"],
  "warp.count": ["warp.gap", "warp.width_mm"],
  "warp.width_mm": ["warp.gap"],
  "weft.gap": ["weft.width_mm"],
  "weft.count": ["weft.gap", "weft.width_mm"],
  "weft.width_mm": ["weft.gap"],
};

/** Fields that name the draft. */
const NAMING: readonly string[] = ["weave", "draft", "image"];

type Plain = Readonly<Record<string, unknown>>;

/**
 * The fabric with other values of fields, by their dotted names; undefined leaves a field out.
 *
 * @throws InputError a value that is out of range or of another type, or a field that names the draft.
 */
export function withFields(fabric: Fabric, values: Plain): Fabric {
  let fields = fabric.fields as Plain;
  for (const [field, value] of Object.entries(values)) {
    // The draft at hand would no longer be the one that is named.
    if (NAMING.includes(field)) throw new InputError(`${field} cannot be set alone: choose a weave, or open a file.`);
    fields = replaced(fields, field, value);
    const others = Object.hasOwn(INSTEAD_OF, field) ? INSTEAD_OF[field] : undefined;
    if (value !== undefined) for (const other of others ?? []) fields = replaced(fields, other, undefined);
  }
  return rewoven(fabric, validateFields(fields));
}

function replaced(fields: Plain, field: string, value: unknown): Plain {
  const [key, ...inner] = field.split(".") as [string, ...string[]];
  if (inner.length === 0) return { ...fields, [key]: value };
  const table = Object.hasOwn(fields, key) ? fields[key] : {};
  return { ...fields, [key]: { ...(table as Plain), [inner.join(".")]: value } };
}

/**
 * The fabric in another named weave. Its own colours stay where the new weave has no order of colours.
 *
 * @throws InputError no such weave.
 */
export function withWeave(fabric: Fabric, weave: string): Fabric {
  if (typeof weave !== "string") throw new InputError('The weave has no name: write "twill 3/1".');
  const { draft: _draft, image: _image, weaves: _weaves, artwork: _artwork, ...named } = fabric.fields;
  const { name: _name, description: _description, ...kept } = named;
  const draft = loadDraft({ weave });
  const hasOrder = draft.palette !== null;
  const fields: FabricFields = hasOrder
    ? { ...kept, weave, warp: withoutColour(kept.warp), weft: withoutColour(kept.weft) }
    : { ...kept, weave };
  return { fields: validateFields(fields), draft };
}

function withoutColour(table: FabricFields["warp"]): FabricFields["warp"] {
  const { color: _, ...rest } = table ?? {};
  return rest;
}
