/** Fields of the fabric, and the weave that they name. */
import { loadDraft, validateFields, type FabricFields } from "loomlight-fabric";

import type { Fabric } from "../state/document.ts";

/** Fields that say the same thing twice: a new value of one takes the place of the others. A count beside a gap weighs. */
const INSTEAD_OF: Readonly<Record<string, readonly string[]>> = {
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

type Plain = Readonly<Record<string, unknown>>;

/**
 * The fabric with another value of a field, by its dotted name; undefined leaves the field out.
 *
 * @throws InputError a value that is out of range or of another type.
 */
export function withField(fabric: Fabric, field: string, value: unknown): Fabric {
  let fields = replaced(fabric.fields as Plain, field, value);
  if (value !== undefined) for (const other of INSTEAD_OF[field] ?? []) fields = replaced(fields, other, undefined);
  return { ...fabric, fields: validateFields(fields) };
}

function replaced(fields: Plain, field: string, value: unknown): Plain {
  const [key, inner] = field.split(".") as [string, string?];
  if (inner === undefined) return { ...fields, [key]: value };
  return { ...fields, [key]: { ...(fields[key] as Plain | undefined), [inner]: value } };
}

/**
 * The fabric in another named weave. Its own colours stay where the new weave has no order of colours.
 *
 * @throws InputError no such weave.
 */
export function withWeave(fabric: Fabric, weave: string): Fabric {
  const { draft: _draft, image: _image, name: _name, description: _description, ...kept } = fabric.fields;
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
