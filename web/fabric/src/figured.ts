/** Figured cloth: a motif in one structure on a ground in another, as a jacquard loom weaves damask. */
import { bindFloats } from "./binding.ts";
import { parseColour } from "./colour.ts";
import { isUp, makeDraft, structureOf, type Draft, type Structure } from "./draft.ts";
import { InputError } from "./errors.ts";
import { argyle, lozenges, OGEE_ASPECT, ogeeDamask, type Mask } from "./motifs.ts";
import { rint } from "./numbers.ts";
import { flatRows, fromPalette } from "./palette.ts";
import { MAXIMUM_NAMED_THREADS, sateen, satin, twill } from "./structures.ts";

/** The ogee damask on so many ends (a multiple of 16 from 160): satin 8/3 on sateen 8/3. */
export function damask(ends: number): Draft {
  const picks = rint(ends * OGEE_ASPECT);
  check("damask", ends, picks, 16, 160);
  const structure = figured(ogeeDamask(ends, picks), satin(8, 3), sateen(8, 3), 10);
  return twoColoured(structure, `damask ${ends}`, "#e9dfc6", "#8c6a2f");
}

/** Argyle diamonds on so many ends (a multiple of 8 from 32): 3/1 twill on 1/3 twill. */
export function argyleCloth(ends: number): Draft {
  const picks = Math.floor((ends * 3) / 2);
  check("argyle", ends, picks, 8, 32);
  const structure = figured(argyle(ends, picks), twill([3, 1]), twill([1, 3]), 5);
  return twoColoured(structure, `argyle ${ends}`, "#39465c", "#e8e0cf");
}

/** Diamonds within diamonds on so many ends (a multiple of 16 from 48): satin 8/3 on sateen 8/3. */
export function diamondFigure(ends: number): Draft {
  check("diamond figure", ends, ends, 16, 48);
  const structure = figured(lozenges(ends, ends), satin(8, 3), sateen(8, 3), 10);
  return twoColoured(structure, `diamond figure ${ends}`, "#5d1f2e", "#d9a9a0");
}

/** `figure` inside the mask and `ground` elsewhere, with floats above `floatLimit` threads bound. */
function figured(mask: Mask, figure: Structure, ground: Structure, floatLimit: number): Structure {
  const structure = structureOf(mask.height, mask.width, (pick, end) => {
    const chosen = mask.inside[pick * mask.width + end] === 1 ? figure : ground;
    return isUp(chosen, pick % chosen.picks, end % chosen.ends);
  });
  bindFloats(structure, floatLimit);
  return structure;
}

function check(name: string, ends: number, picks: number, multiple: number, lowest: number): void {
  if (ends % multiple === 0 && ends >= lowest && Math.max(ends, picks) <= MAXIMUM_NAMED_THREADS) return;
  const largest = Math.floor((MAXIMUM_NAMED_THREADS * ends) / Math.max(ends, picks, 1));
  let nearest = Math.max(lowest, Math.min(rint(ends / multiple) * multiple, largest));
  nearest -= nearest % multiple;
  throw new InputError(
    `"${name} ${ends}" cannot be woven: its ends must be a multiple of ${multiple}, at least ${lowest}, with at most ` +
      `${MAXIMUM_NAMED_THREADS} ends and picks; ${nearest} would do.`,
  );
}

function twoColoured(structure: Structure, name: string, warp: string, weft: string): Draft {
  const palette = flatRows([parseColour(warp, "palette"), parseColour(weft, "palette")]);
  return makeDraft(structure, {
    name,
    warp: fromPalette(structure.ends, [0], palette),
    weft: fromPalette(structure.picks, [1], palette),
    palette,
  });
}
