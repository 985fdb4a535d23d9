/**
 * Colour-and-weave effects: a simple structure and an order of colours that together make a figure.
 *
 * Index 0 of a colour order is the dark colour, 1 the light one.
 */
import { parseColour } from "./colour.ts";
import { makeDraft, tileStructure, type Draft, type Structure } from "./draft.ts";
import { lcm } from "./numbers.ts";
import { flatRows, fromPalette, runs } from "./palette.ts";
import { plain, twill } from "./structures.ts";

type Palette = readonly string[];

const CHARCOAL_AND_CREAM: Palette = ["#23262e", "#ece4d3"];
const INDIGO_AND_ECRU: Palette = ["#22335c", "#e6dfce"];
const NAVY_AND_CHALK: Palette = ["#1d2536", "#c9ccd2"];
const BLUE_AND_WHITE: Palette = ["#3a6ea8", "#f2f0ea"];

/** A structure with colour orders (palette index per end and per pick); both repeat until they fit together. */
export interface Effect {
  readonly structure: Structure;
  readonly warpOrder: readonly number[];
  readonly weftOrder: readonly number[];
  readonly palette: Palette;
}

/** The effect as a draft of one full repeat, in its default colours. */
export function effectDraft(effect: Effect, name: string): Draft {
  const { structure, warpOrder, weftOrder } = effect;
  const ends = lcm(structure.ends, warpOrder.length);
  const picks = lcm(structure.picks, weftOrder.length);
  const palette = flatRows(effect.palette.map((colour) => parseColour(colour, "palette")));
  return makeDraft(tileStructure(structure, ends / structure.ends, picks / structure.picks), {
    name,
    warp: fromPalette(ends, warpOrder, palette),
    weft: fromPalette(picks, weftOrder, palette),
    palette,
  });
}

function effect(
  structure: Structure,
  warpOrder: readonly number[],
  weftOrder: readonly number[],
  palette = CHARCOAL_AND_CREAM,
): Effect {
  return { structure, warpOrder, weftOrder, palette };
}

/** 2/2 twill with `width` dark and `width` light threads both ways; 4 makes the classic tooth. */
export function houndstooth(width: number): Effect {
  const order = runs([0, width], [1, width]);
  return effect(twill([2, 2]), order, order);
}

/** Plain weave, one dark and one light: every end covers its own colour, which gives fine lines. */
export function hairline(): Effect {
  return effect(plain(), [0, 1], [1, 0], NAVY_AND_CHALK);
}

/** Plain weave of alternating dark and light, whose order flips every `width` threads. */
export function logCabin(width: number): Effect {
  const alternate = Array.from({ length: width }, (_, thread) => thread % 2);
  const order = [...alternate, ...alternate.map((index) => 1 - index)];
  return effect(plain(), order, order);
}

/** Glen Urquhart check: `groups` of four dark and four light beside as wide a field of two and two. */
export function glenCheck(groups: number): Effect {
  const wide = Array.from({ length: groups }, () => runs([0, 4], [1, 4])).flat();
  const narrow = Array.from({ length: 2 * groups }, () => runs([0, 2], [1, 2])).flat();
  return effect(twill([2, 2]), [...wide, ...narrow], [...wide, ...narrow]);
}

/** Even checks in 2/2 twill: solid squares joined by diagonal half-tones; 8 and wider show as checks. */
export function shepherdsCheck(width: number): Effect {
  const order = runs([0, width], [1, width]);
  return effect(twill([2, 2]), order, order);
}

/** Even checks in plain weave. */
export function gingham(width: number): Effect {
  const order = runs([0, width], [1, width]);
  return effect(plain(), order, order, BLUE_AND_WHITE);
}

/** 2/1 twill in the dark colour with one light end in every `width`. */
export function pinstripe(width: number): Effect {
  return effect(twill([2, 1]), runs([0, width - 1], [1, 1]), [0], NAVY_AND_CHALK);
}

/** 3/1 twill, indigo warp, undyed weft. */
export function denim(): Effect {
  return effect(twill([3, 1]), [0], [1], INDIGO_AND_ECRU);
}

/** Plain weave, coloured warp, white weft. */
export function chambray(): Effect {
  return effect(plain(), [0], [1], BLUE_AND_WHITE);
}
