/** What every fabric of the page must be: one that all panels and the renderer can show. */
import { clothFacts, InputError, requireInterlacing, validateFields } from "loomlight-fabric";
import { lookOf, MAXIMUM_CROSSINGS } from "loomlight-web/look";

import { woven, type Fabric } from "./document.ts";

const known = new WeakSet<Fabric>();

/**
 * The fabric, its fields in the order of files, once everything that is shown of it has been computed.
 *
 * @throws InputError fields out of range, colours that do not fit the draft, a yarn count or albedos that cannot be.
 */
export function usable(given: Fabric): Fabric {
  if (known.has(given)) return given;
  const fabric = { ...given, fields: validateFields(given.fields) };
  requireInterlacing(fabric.draft);
  const draft = woven(fabric);
  const { weight } = clothFacts(fabric.fields, draft);
  if (!Number.isFinite(weight)) throw new InputError("The draft has threads of no spacing or width.");
  // Larger drafts are edited, not lit: the renderer says so.
  if (draft.ends * draft.picks <= MAXIMUM_CROSSINGS) lookOf(fabric.fields, fabric.draft);
  known.add(fabric);
  return fabric;
}
