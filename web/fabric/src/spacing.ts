/** Spacing and width of the threads of a fabric, from its fields or from the draft. */
import type { FabricFields } from "./generated.ts";
import type { Draft } from "./draft.ts";
import type { FamilyName } from "./fields.ts";
import { CM_PER_INCH, DEFAULT_SETT_PER_CM, yarnDiameterMm } from "./textile.ts";
import { kindOf } from "./yarns.ts";

const MM_PER_CM = 10;

/** Threads/cm that the fields give for a family, in centimetres or in inches; null without. */
export function threadsPerCm(fields: FabricFields, family: FamilyName): number | null {
  const [perCm, perInch] = family === "warp" ? [fields.ends_per_cm, fields.epi] : [fields.picks_per_cm, fields.ppi];
  return perInch !== undefined ? perInch / CM_PER_INCH : (perCm ?? null);
}

/**
 * Distance that each thread of a family takes up, millimetres.
 *
 * The fields' threads/cm come first; the draft's spacing, where there is one, keeps its proportions and is scaled to
 * them. Without either, the other family's density is used, so that the cloth is square. Of an artwork with a regulator
 * the fields' density counts the picks that take up cloth.
 */
export function familySpacing(fields: FabricFields, family: FamilyName, draft: Draft): Float64Array {
  const [threads, other, count] =
    family === "warp" ? [draft.warp, draft.weft, draft.ends] : [draft.weft, draft.warp, draft.picks];
  const own = threadsPerCm(fields, family);
  if (threads.spacingMm !== null) {
    const takeUp = family === "weft" ? takeUpOf(fields, draft) : 1;
    const scale = own === null ? 1 : (takeUp * MM_PER_CM) / own / mean(threads.spacingMm);
    return threads.spacingMm.map((spacing) => spacing * scale);
  }
  const density = own ?? threadsPerCm(fields, family === "warp" ? "weft" : "warp");
  if (density !== null) return new Float64Array(count).fill(MM_PER_CM / density);
  if (other.spacingMm !== null) return new Float64Array(count).fill(mean(other.spacingMm));
  return new Float64Array(count).fill(MM_PER_CM / DEFAULT_SETT_PER_CM);
}

/** Share of the picks that take up cloth: all but those while the regulator of an artwork stands still. */
function takeUpOf(fields: FabricFields, draft: Draft): number {
  const first = fields.artwork?.regulator;
  const wefts = draft.weft.colorIndex;
  if (first === undefined || wefts === null) return 1;
  // Wefts are rows 1, 2 … of the palette of an artwork.
  // A draft of another origin may have no such wefts.
  return wefts.filter((weft) => weft < first).length / wefts.length || 1;
}

/**
 * The fields without the artwork that the draft was woven of, for a draft that stands by itself: the same cloth, whose
 * densities count every pick.
 */
export function withoutArtwork(fields: FabricFields, draft: Draft): FabricFields {
  const { weaves: _weaves, artwork: _artwork, image: _image, ...kept } = fields;
  const takeUp = takeUpOf(fields, draft);
  if (takeUp === 1) return kept;
  if (kept.picks_per_cm !== undefined) return { ...kept, picks_per_cm: kept.picks_per_cm / takeUp };
  return kept.ppi === undefined ? kept : { ...kept, ppi: kept.ppi / takeUp };
}

/**
 * Width of each thread of a family, millimetres, as many as `spacing`.
 *
 * The family's own width or gap comes first, then its count, the draft's thickness, the fabric's gap, and that of its
 * kind of yarn. A yarn of a count is at least as wide as it is when round; where its kind leaves a smaller gap it
 * spreads towards that, by the kind's spread at most.
 */
export function familyWidth(
  fields: FabricFields,
  family: FamilyName,
  draft: Draft,
  spacing: Float64Array,
): Float64Array {
  const [table, kind] = [fields[family] ?? {}, kindOf(fields, family)];
  const ofCount = table.count === undefined ? null : yarnDiameterMm(table.count, kind);
  const { gap, width_mm: width } = table;
  if (width !== undefined) return new Float64Array(spacing.length).fill(width);
  if (gap !== undefined) return spacing.map((distance) => distance * (1 - gap));
  if (ofCount !== null)
    return spacing.map((distance) => Math.min(Math.max((1 - kind.gap) * distance, ofCount), ofCount * kind.spread));
  const { thicknessMm } = draft[family];
  if (thicknessMm !== null) return thicknessMm;
  return spacing.map((distance) => distance * (1 - (fields.gap ?? kind.gap)));
}

function mean(values: Float64Array): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}
