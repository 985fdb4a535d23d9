/** What yarns show close up, as numbers that shaders read; see `scattering/detail.py`. */
import { PLY_TWIST_DEG, type YarnFields } from "loomlight-fabric";

import { DETAIL_FIELDS, MAX_TONE, RECORDS, SECTION_ANGLE, SLUB_LENGTH, TONE_OF_TILT } from "../generated.ts";

type DetailName = (typeof DETAIL_FIELDS)[number][0];

/** Numbers of one family as in Python's `YarnDetail`: plies, stray of fibres, slubs, hairs …; angles in radians. */
export type YarnDetail = Readonly<Record<DetailName, number>>;

/** Numbers of a yarn whose fields are absent; others are 0. */
const DEFAULTS: YarnFields = { plies: 1, ply_twist_deg: PLY_TWIST_DEG };

/** The detail that the fields of [warp] or [weft] describe. */
export function detailOf(table: YarnFields): YarnDetail {
  return Object.fromEntries(
    DETAIL_FIELDS.map(([name, key, unit]) => [name, (table[key] ?? (DEFAULTS[key] as number | undefined) ?? 0) * unit]),
  ) as YarnDetail;
}

/** Whether the yarn shows anything beside its smooth surface. */
export function isDetailed({ plies, ply_twist: _, ...amounts }: YarnDetail): boolean {
  return plies > 1 || Math.max(...Object.values(amounts)) > 0;
}

/**
 * Fields of the record of a family.
 *
 * @param width mean visible width of the yarns, millimetres.
 * @param twist ψ, radians.
 */
export function detailNumbers(detail: YarnDetail, width: number, twist: number): Record<string, number> {
  const circumference = (Math.PI * width) / Math.sin(SECTION_ANGLE);
  const lean = detail.ply_twist - twist;
  return {
    ...Object.fromEntries(Object.entries(detail).filter(([name]) => name in RECORDS.Family.fields)),
    has_plies: detail.plies > 1 ? 1 : 0,
    plies_per_mm: detail.plies / (circumference * Math.cos(detail.ply_twist)),
    ply_sine: Math.sin(lean),
    ply_cosine: Math.cos(lean),
    fibre_tone: Math.min(TONE_OF_TILT * detail.fibre_tilt, MAX_TONE),
    slubs_per_mm: 1 / (SLUB_LENGTH * width),
  };
}
