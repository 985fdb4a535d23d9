/** What yarns show close up, as numbers that shaders read; see `scattering/detail.py`. */
import { PLY_TWIST_DEG, type YarnFields } from "loomlight-fabric";

import { MAX_TONE, SECTION_ANGLE, SLUB_LENGTH, TONE_OF_TILT } from "../generated.ts";

const RADIANS = Math.PI / 180;

/** Plies, stray of fibres, slubs and hairs of one family. */
export interface YarnDetail {
  readonly plies: number;
  /** Angle of the plies to the yarn, radians. */
  readonly plyTwist: number;
  /** Standard deviation of the angles by which fibres stray, radians. */
  readonly fibreTilt: number;
  readonly slub: number;
  readonly hairiness: number;
}

/** The detail that the fields of [warp] or [weft] describe. */
export function detailOf(table: YarnFields): YarnDetail {
  return {
    plies: table.plies ?? 1,
    plyTwist: (table.ply_twist_deg ?? PLY_TWIST_DEG) * RADIANS,
    fibreTilt: (table.fibre_tilt_deg ?? 0) * RADIANS,
    slub: table.slub ?? 0,
    hairiness: table.hairiness ?? 0,
  };
}

/** Whether the yarn shows anything beside its smooth surface. */
export function isDetailed({ plies, fibreTilt, slub, hairiness }: YarnDetail): boolean {
  return plies > 1 || Math.max(fibreTilt, slub, hairiness) > 0;
}

/**
 * Fields of the record of a family.
 *
 * @param width mean visible width of the yarns, millimetres.
 * @param twist ψ, radians.
 */
export function detailNumbers(detail: YarnDetail, width: number, twist: number): Record<string, number> {
  const circumference = (Math.PI * width) / Math.sin(SECTION_ANGLE);
  const lean = detail.plyTwist - twist;
  return {
    has_plies: detail.plies > 1 ? 1 : 0,
    plies_per_mm: detail.plies / (circumference * Math.cos(detail.plyTwist)),
    ply_sine: Math.sin(lean),
    ply_cosine: Math.cos(lean),
    fibre_tilt: detail.fibreTilt,
    fibre_tone: Math.min(TONE_OF_TILT * detail.fibreTilt, MAX_TONE),
    slub: detail.slub,
    slubs_per_mm: 1 / (SLUB_LENGTH * width),
    per_half_width: 2 / width,
    hairiness: detail.hairiness,
  };
}
