/** Colours of single threads, painted or swapped, as the list that a fabric file holds. */
import { toHex, type Colour } from "./colour.ts";
import { colouredDraft, usedRows } from "./colours.ts";
import type { Draft } from "./draft.ts";
import type { FamilyName } from "./fields.ts";
import type { FabricFields } from "./generated.ts";

/** sRGB hex of every thread of a family, as the fabric shows it. */
export function threadHexes(coloured: Draft, family: FamilyName): string[] {
  const { colors } = coloured[family];
  return Array.from({ length: (colors?.length ?? 0) / 3 }, (_, thread) =>
    toHex(colors!.subarray(thread * 3, thread * 3 + 3)),
  );
}

/** The fields in which every thread of a family of the woven draft has the colour listed for it. */
export function withThreadHexes(
  fields: FabricFields,
  named: Draft,
  family: FamilyName,
  hexes: readonly string[],
): FabricFields {
  return { ...fields, [family]: { ...withoutColour(fields[family]), color: colourList(named, family, hexes) } };
}

/** The shortest list that gives each thread its colour: one colour, one a role, or one a thread of a period. */
function colourList(named: Draft, family: FamilyName, hexes: readonly string[]): Colour | Colour[] {
  if (hexes.every((hex) => hex === hexes[0])) return hexes[0]!;
  const byRole = roleList(named, family, hexes);
  if (byRole !== null) return byRole;
  const roles = usedRows(named[family]).length;
  for (let period = 2; period < hexes.length; period++) {
    // A list no longer than the roles would be read as theirs; one that does not fit would make the repeat grow.
    const fits = hexes.length % period === 0 && (roles < 2 || period > roles);
    if (fits && hexes.every((hex, thread) => hex === hexes[thread % period])) return hexes.slice(0, period);
  }
  // As many threads as roles: twice the list is in thread order for certain.
  return roles >= 2 && hexes.length <= roles ? [...hexes, ...hexes] : [...hexes];
}

/** The colour of each role, if all threads of a role have the same one. */
function roleList(named: Draft, family: FamilyName, hexes: readonly string[]): string[] | null {
  const { colorIndex } = named[family];
  const used = usedRows(named[family]);
  if (colorIndex === null || used.length < 2 || hexes.length % colorIndex.length !== 0) return null;
  const list: string[] = [];
  for (const row of used) {
    const first = colorIndex.indexOf(row);
    const isUniform = hexes.every((hex, thread) => colorIndex[thread % colorIndex.length] !== row || hex === hexes[first]);
    if (!isUniform) return null;
    list.push(hexes[first]!);
  }
  return list;
}

/**
 * The named draft and fields in which the draft itself holds all colours, as a draft file does.
 *
 * What changes threads or their number needs it: a list of colours in the fields fits one number of threads.
 */
export function withColoursInDraft(
  fields: FabricFields,
  named: Draft,
): { fields: FabricFields; draft: Draft } {
  const coloured = colouredDraft(named, fields);
  const palette: number[] = [];
  const rows = new Map<string, number>();
  const index = (colors: Float64Array): Int32Array =>
    Int32Array.from({ length: colors.length / 3 }, (_, thread) => {
      const colour = colors.subarray(thread * 3, thread * 3 + 3);
      const key = colour.join();
      const row = rows.get(key) ?? rows.size;
      if (row === rows.size) {
        rows.set(key, row);
        palette.push(...colour);
      }
      return row;
    });
  const draft: Draft = {
    ...coloured,
    warp: { ...coloured.warp, colorIndex: index(coloured.warp.colors!) },
    weft: { ...coloured.weft, colorIndex: index(coloured.weft.colors!) },
    palette: null,
    source: null,
  };
  return {
    fields: { ...fields, warp: withoutColour(fields.warp), weft: withoutColour(fields.weft) },
    draft: { ...draft, palette: Float64Array.from(palette) },
  };
}

function withoutColour<T extends { readonly color?: unknown; readonly albedo?: unknown }>(
  table: T | undefined,
): Omit<T, "color" | "albedo"> {
  const { color: _color, albedo: _albedo, ...rest } = table ?? ({} as T);
  return rest;
}

/** The colours that a family shows, most frequent first, with how many threads have them. */
export function coloursInUse(hexes: readonly string[]): { hex: string; count: number }[] {
  const counts = new Map<string, number>();
  for (const hex of hexes) counts.set(hex, (counts.get(hex) ?? 0) + 1);
  return [...counts].map(([hex, count]) => ({ hex, count })).sort((a, b) => b.count - a.count);
}

