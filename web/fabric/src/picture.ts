/** Drawdowns as pictures: dark is warp up, the bottom row is pick 1, the left column end 1. */
import { makeDraft, MAXIMUM_THREADS, structureOf, type Draft } from "./draft.ts";
import { InputError } from "./errors.ts";

/**
 * The draft that a picture draws, one pixel a crossing; what is transparent counts as white.
 *
 * @param rgba pixels [height·width·4], top row first, sRGB-encoded, 0 to 255.
 * @throws InputError too large a picture, or one without both dark and light.
 */
export function draftOfPixels(rgba: Uint8ClampedArray, width: number, height: number, file: string): Draft {
  if (Math.max(width, height) > MAXIMUM_THREADS)
    throw new InputError(
      `${file} has ${width} x ${height} pixels; a drawdown has one pixel a crossing, and at most ${MAXIMUM_THREADS} ` +
        "ends and picks can be used.",
    );
  const structure = structureOf(height, width, (pick, end) => {
    const at = ((height - 1 - pick) * width + end) * 4;
    const alpha = rgba[at + 3]! / 255;
    const mean = (rgba[at]! + rgba[at + 1]! + rgba[at + 2]!) / 3 / 255;
    return 1 - alpha * (1 - mean) < 0.5;
  });
  const up = structure.drawdown.includes(1);
  if (!up || !structure.drawdown.includes(0)) {
    const [present, absent] = up ? ["black", "white"] : ["white", "black"];
    throw new InputError(
      `${file} holds only ${present} pixels and no ${absent} ones; black crossings have the warp on top, white ones ` +
        "the weft, and cloth needs both.",
    );
  }
  return makeDraft(structure, { name: file.replace(/\.[^.]*$/, "") });
}
