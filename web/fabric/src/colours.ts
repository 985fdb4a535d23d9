/** The colour of every thread: colours of the fields, in the order of the draft. */
import { coloursInOrder, parseColour, type Rgb } from "./colour.ts";
import type { Draft, Threads } from "./draft.ts";
import type { FamilyName } from "./fields.ts";
import type { FabricFields } from "./generated.ts";
import { WARP_COLOUR, WEFT_COLOUR, withPalette } from "./palette.ts";

/**
 * The draft with a colour for every thread: the fields', else its own, else a dark warp and a light weft.
 *
 * Where a family of the draft has two or more colours in an order of its own, a list of as many replaces them, in the
 * order of the draft's palette. A longer list, and any list where there is no such order, is in thread order and
 * repeats; the repeat of the draft then grows.
 *
 * @throws InputError a list that is shorter than the draft's order, or that makes too long a repeat.
 */
export function colouredDraft(draft: Draft, fields: FabricFields): Draft {
  const warp = listed(fields, "warp", draft.warp);
  const weft = listed(fields, "weft", draft.weft);
  const byRole = { ...draft, warp: withRoles(draft.warp, warp), weft: withRoles(draft.weft, weft) };
  return withPalette(byRole, warp, weft);
}

/** The rows of the palette that a family uses, in ascending order: the roles that a list of colours fills. */
export function usedRows(threads: Threads): number[] {
  return threads.colorIndex === null ? [] : [...new Set(threads.colorIndex)].sort((a, b) => a - b);
}

/** Threads whose `colorIndex` counts the colours that this family uses; null for thread order. */
function withRoles(threads: Threads, colours: readonly Rgb[] | null): Threads {
  if (threads.colorIndex === null || colours === null) return threads;
  const used = usedRows(threads);
  const inThreadOrder = used.length === 1 || colours.length > used.length;
  if (inThreadOrder) return { ...threads, colorIndex: null };
  const role = new Map(used.map((row, index) => [row, index]));
  return { ...threads, colorIndex: threads.colorIndex.map((row) => role.get(row)!) };
}

/** The colours to apply; null leaves the draft's own. */
function listed(fields: FabricFields, family: FamilyName, threads: Threads): Rgb[] | null {
  const given = fields[family]?.color ?? fields[family]?.albedo;
  if (given === undefined && threads.colors !== null) return null;
  const stated = given ?? (family === "warp" ? WARP_COLOUR : WEFT_COLOUR);
  return coloursInOrder(stated, `${family}.color`).map((colour) => parseColour(colour, `${family}.color`));
}
