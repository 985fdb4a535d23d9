/** Artwork whose colours are weaves: woven anew when these change, or read as a drawdown. */
import {
  BACK_WEAVE,
  draftOfPixels,
  firstWeaves,
  InputError,
  MAX_WEFTS,
  pixelsOfArtwork,
  validateFields,
  weaveArtwork,
  weaveLists,
  type FabricFields,
} from "loomlight-fabric";

import { hasWeaves, isArtwork, type Fabric } from "../state/document.ts";
import { requireOneOf, requireWhole } from "./checks.ts";

/** Fields that an artwork is woven by; those of the sett too while its regulator stands still for some wefts. */
const WOVEN_BY = ["weaves", "artwork"] as const;
const SETTS = ["ends_per_cm", "picks_per_cm", "epi", "ppi"] as const;

/**
 * The fabric with other fields, woven anew where the artwork's weaves are others.
 *
 * @throws InputError weaves of a picture that is not at hand, or ones that cannot be woven.
 */
export function rewoven(fabric: Fabric, fields: FabricFields): Fabric {
  const by: readonly (keyof FabricFields)[] = fields.artwork?.regulator === undefined ? WOVEN_BY : [...WOVEN_BY, ...SETTS];
  const isSame = by.every((field) => JSON.stringify(fields[field]) === JSON.stringify(fabric.fields[field]));
  if (isSame) return { ...fabric, fields };
  const { artwork } = fabric;
  if (artwork === undefined || fields.image === undefined)
    throw new InputError("weaves cannot be set without the picture whose colours they are: open the artwork.");
  return { fields, draft: weaveArtwork(artwork, fields, fields.image).draft, artwork };
}

/**
 * The fabric of a picture, read in another way: each colour a weave, or dark crossings where the warp is on top.
 *
 * @throws InputError a fabric of no picture, or one that is no drawdown.
 */
export function withReading(fabric: Fabric, as: unknown): Fabric {
  const { artwork, fields } = fabric;
  if (artwork === undefined || fields.image === undefined) throw new InputError("There is no picture to be read: open one.");
  const { weaves: _weaves, artwork: _artwork, ...kept } = fields;
  if (requireOneOf("as", as, ["weaves", "drawdown"] as const) === "weaves") return rewoven(fabric, validateFields({ ...kept, weaves: firstWeaves(artwork) }));
  return { fields: kept, draft: draftOfPixels(pixelsOfArtwork(artwork), artwork.ends, artwork.rows, fields.image), artwork };
}

/**
 * The fabric with so many wefts: new ones lie on the back everywhere, until they get weaves.
 *
 * @throws InputError another fabric than an artwork, or more wefts than looms have.
 */
export function withWefts(fabric: Fabric, given: unknown): Fabric {
  const wefts = requireWhole("wefts", given, 1, MAX_WEFTS);
  if (!isArtwork(fabric) || !hasWeaves(fabric.fields)) throw new InputError("Only an artwork has several wefts: open one.");
  const { artwork: _order, ...kept } = fabric.fields;
  const lists = [...weaveLists(kept.weaves!)].map(([colour, listed]): [string, string | readonly string[]] => {
    const more = Array.from({ length: wefts }, (_, weft) => listed[weft] ?? BACK_WEAVE);
    return [colour, wefts === 1 ? more[0]! : more];
  });
  // Order and regulator speak of wefts that there were; the longest float stays.
  const longest = fabric.fields.artwork?.longest_float;
  const artwork = longest === undefined ? {} : { artwork: { longest_float: longest } };
  return rewoven(fabric, validateFields({ ...kept, ...artwork, weaves: Object.fromEntries(lists) }));
}
