/**
 * The types of fields of a fabric file; `generated.ts` has the fields. Fields that a file omits are absent, so that a
 * file that is read and written again says no more than it did.
 */
/** The type of a field, and its range. */
export type FieldKind =
  | { readonly kind: "number" | "integer"; readonly low: number; readonly high: number }
  | { readonly kind: "text"; readonly mayBeEmpty: boolean }
  | { readonly kind: "colour" | "colours" | "boolean" | "yarn" | "maps" | "weaves" }
  | { readonly kind: "table"; readonly fields: FieldTable };

/** [maps] as the file has it: pictures over the surface, which Python reads; pages keep it. */
export interface SurfaceMaps {
  readonly [name: string]: string | SurfaceMaps | number | boolean | readonly (string | number)[];
}

/** [weaves] as the file has it: what the colours of an artwork are, one weave a weft. */
export interface ArtworkWeaves {
  readonly [colour: string]: string | readonly string[];
}

/** Fields of a table by their keys, in the order in which a file is written. */
export interface FieldTable {
  readonly [key: string]: FieldKind;
}

/** The families of threads. */
export const FAMILIES = ["warp", "weft"] as const;
export type FamilyName = (typeof FAMILIES)[number];
