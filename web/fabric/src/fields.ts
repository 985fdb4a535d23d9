/**
 * The fields of a fabric file with their types and ranges, under the same keys as the TOML file.
 *
 * A test holds the table `FABRIC` against `src/loomlight/fabric/file.py`. Fields that a file omits are absent, so that
 * a file that is read and written again says no more than it did.
 */
import type { Colour } from "./colour.ts";

/** [warp] or [weft]. */
export interface YarnFields {
  readonly yarn?: string;
  readonly color?: Colour | readonly Colour[];
  readonly albedo?: Colour | readonly Colour[];
  readonly specular?: number;
  readonly specular_tint?: Colour;
  readonly translucency?: number;
  readonly roughness?: number;
  readonly height_scale?: number;
  readonly inclination_deg?: number;
  readonly twist_deg?: number;
  readonly plies?: number;
  readonly ply_twist_deg?: number;
  readonly fibre_tilt_deg?: number;
  readonly slub?: number;
  readonly hairiness?: number;
  readonly gap?: number;
  readonly count?: string;
  readonly width_mm?: number;
  readonly diffuse_reflect?: Colour;
  readonly diffuse_transmit?: Colour;
  readonly specular_reflect?: Colour;
  readonly specular_transmit?: Colour;
}

/** A whole fabric file. */
export interface FabricFields {
  readonly name?: string;
  readonly description?: string;
  readonly weave?: string;
  readonly draft?: string;
  readonly image?: string;
  readonly ends_per_cm?: number;
  readonly picks_per_cm?: number;
  readonly epi?: number;
  readonly ppi?: number;
  readonly gap?: number;
  readonly yarn?: string;
  readonly diffuse_blend?: number;
  readonly optical_depth?: number;
  readonly interreflection?: boolean;
  readonly warp?: YarnFields;
  readonly weft?: YarnFields;
  readonly sheen?: { readonly strength?: number; readonly roughness?: number };
  readonly variation?: { readonly fibre_noise?: number; readonly colour_noise?: number; readonly seed?: number };
}

/** What a field holds. */
export type FieldKind =
  | { readonly kind: "number" | "integer"; readonly low: number; readonly high: number }
  | { readonly kind: "text"; readonly mayBeEmpty: boolean }
  | { readonly kind: "colour" | "colours" | "boolean" | "yarn" }
  | { readonly kind: "table"; readonly fields: FieldTable };

/** Fields of a table by their keys, in the order in which a file is written. */
export interface FieldTable {
  readonly [key: string]: FieldKind;
}

const number = (low: number, high: number): FieldKind => ({ kind: "number", low, high });
const text: FieldKind = { kind: "text", mayBeEmpty: true };
const name: FieldKind = { kind: "text", mayBeEmpty: false };
const colour: FieldKind = { kind: "colour" };
const fraction = number(0, 1);
const gap = number(0, 0.95);
const yarn: FieldKind = { kind: "yarn" };

/** [warp] and [weft]. */
export const YARN: FieldTable = {
  yarn,
  color: { kind: "colours" },
  albedo: { kind: "colours" },
  specular: fraction,
  specular_tint: colour,
  translucency: fraction,
  roughness: number(0.01, 1),
  height_scale: number(0.01, 2),
  inclination_deg: number(0, 80),
  twist_deg: number(-89, 89),
  plies: { kind: "integer", low: 1, high: 12 },
  ply_twist_deg: number(-60, 60),
  fibre_tilt_deg: number(0, 30),
  slub: fraction,
  hairiness: fraction,
  gap,
  count: name,
  width_mm: number(0.001, 1000),
  diffuse_reflect: colour,
  diffuse_transmit: colour,
  specular_reflect: colour,
  specular_transmit: colour,
};

/** The whole file. */
export const FABRIC: FieldTable = {
  name: text,
  description: text,
  weave: name,
  draft: name,
  image: name,
  ends_per_cm: number(0.1, 1000),
  picks_per_cm: number(0.1, 1000),
  epi: number(0.254, 2540),
  ppi: number(0.254, 2540),
  gap,
  yarn,
  diffuse_blend: fraction,
  optical_depth: number(0.01, 100),
  interreflection: { kind: "boolean" },
  warp: { kind: "table", fields: YARN },
  weft: { kind: "table", fields: YARN },
  sheen: { kind: "table", fields: { strength: fraction, roughness: fraction } },
  variation: {
    kind: "table",
    fields: { fibre_noise: fraction, colour_noise: fraction, seed: { kind: "integer", low: 0, high: 2 ** 32 - 1 } },
  },
};

/** The families of threads. */
export const FAMILIES = ["warp", "weft"] as const;
export type FamilyName = (typeof FAMILIES)[number];
