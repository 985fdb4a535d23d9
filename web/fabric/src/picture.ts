/** Drawdowns as pictures: dark is warp up, the bottom row is pick 1, the left column end 1. */
import { makeDraft, MAXIMUM_THREADS, structureOf, type Draft } from "./draft.ts";
import { InputError } from "./errors.ts";

type Rgb = readonly [number, number, number];

/** Rec. 709: how bright an eye finds each component. */
const LUMA: Rgb = [0.2126, 0.7152, 0.0722];
/** Colours of a drawing: a photograph, or one that was squeezed as a photograph, has more. */
const DRAWN_COLOURS = 12;
/** Distances in RGB: of colours that count as two, and, as a share of theirs, of pixels that count as one. */
const DISTINCT = 0.1;
const ALIKE = 0.25;

/**
 * The draft that a picture draws, one pixel a crossing; what is transparent counts as white.
 *
 * Pictures are split at half of full brightness. Where all is darker than that, or lighter, and of two colours, the
 * darker one to the eye is the warp.
 *
 * @param rgba pixels [height·width·4], top row first, sRGB-encoded, 0 to 255.
 * @throws InputError too large a picture, or one of a single colour or of several on one side of half.
 */
export function draftOfPixels(rgba: Uint8ClampedArray, width: number, height: number, file: string): Draft {
  requireSize(width, height, file);
  const colourAt = (at: number): Rgb => {
    const alpha = rgba[4 * at + 3]! / 255;
    const onWhite = (channel: number): number => 1 - alpha * (1 - rgba[4 * at + channel]! / 255);
    return [onWhite(0), onWhite(1), onWhite(2)];
  };
  const draft = (isDark: (colour: Rgb) => boolean): ReturnType<typeof structureOf> =>
    structureOf(height, width, (pick, end) => isDark(colourAt((height - 1 - pick) * width + end)));
  let structure = draft(([red, green, blue]) => (red + green + blue) / 3 < 0.5);
  const isDark = structure.drawdown.includes(1);
  if (!isDark || !structure.drawdown.includes(0)) {
    const corner = colourAt(0);
    let [far, distance] = [corner, 0];
    for (let at = 0; at < width * height; at++) {
      const colour = colourAt(at);
      const away = squared(colour, corner);
      if (away > distance) [far, distance] = [colour, away];
    }
    if (distance < DISTINCT ** 2) throw refusal(file, "only pixels of one colour");
    const [warp, weft] = luma(far) < luma(corner) ? [far, corner] : [corner, far];
    structure = draft((colour) => {
      const [toWarp, toWeft] = [squared(colour, warp), squared(colour, weft)];
      if (Math.min(toWarp, toWeft) > ALIKE ** 2 * distance)
        throw refusal(file, `more than two colours, all ${isDark ? "darker" : "lighter"} than half of full brightness`);
      return toWarp < toWeft;
    });
  }
  return makeDraft(structure, { name: file.replace(/\.[^.]*$/, "") });
}

/** Raises InputError where a picture has more pixels a side than ends or picks can be used. */
export function requireSize(width: number, height: number, file: string): void {
  if (Math.max(width, height) > MAXIMUM_THREADS)
    throw new InputError(
      `${file} has ${width} x ${height} pixels; a drawdown or an artwork has one pixel an end and a pick, and at most ` +
        `${MAXIMUM_THREADS} ends and picks can be used.`,
    );
}

/** Whether a picture has more colours than one that was drawn, as photographs have. */
export function looksPhotographed(rgba: Uint8ClampedArray): boolean {
  const colours = new Set<number>();
  for (let at = 0; at < rgba.length && colours.size <= DRAWN_COLOURS; at += 4)
    colours.add((rgba[at + 3]! << 24) | (rgba[at]! << 16) | (rgba[at + 1]! << 8) | rgba[at + 2]!);
  return colours.size > DRAWN_COLOURS;
}

function squared(one: Rgb, other: Rgb): number {
  return (one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2 + (one[2] - other[2]) ** 2;
}

/** How bright an eye finds a colour, of sRGB-encoded levels in [0, 1]. */
export function luma(colour: Rgb): number {
  return colour[0] * LUMA[0] + colour[1] * LUMA[1] + colour[2] * LUMA[2];
}

function refusal(file: string, held: string): InputError {
  return new InputError(
    `${file} holds ${held}; cloth needs dark crossings, where the warp is on top, and light ones, where the ` +
      "weft is.",
  );
}
