/** Artworks from pixels: their colours, how much of the picture each takes, and weaves to begin with. */
import { codeOf, hexOfCode, nearestOf, pixelsOf, unnamed, type Artwork } from "./artwork.ts";
import { plainHex } from "./artwork_fields.ts";
import { InputError } from "./errors.ts";
import { MAX_COLOURS, type FabricFields } from "./generated.ts";
import { rint } from "./numbers.ts";
import { luma, requireSize } from "./picture.ts";

const ALL_COLOURS = 1 << 24;
/** From weft-faced to warp-faced; all of them divide eight threads. */
const SHADES = ["sateen 8/3", "twill 1/3", "twill 3/5", "twill 2/2", "twill 5/3", "twill 3/1", "satin 8/3"];
/** The same, each twice, with lines the other way. */
const MANY_SHADES = SHADES.flatMap((shade) => [shade, shade.startsWith("twill") ? `${shade} s` : shade.replace("/3", "/5")]);

/**
 * The artwork that a picture is; what is transparent counts as white.
 *
 * @param rgba pixels [height·width·4], top row first, sRGB-encoded, 0 to 255.
 * @param fields of a fabric file, whose [weaves] name colours; without them each colour that there is counts.
 * @throws InputError too large a picture, too many colours, or ones without a weave.
 */
export function artworkOfPixels(rgba: Uint8ClampedArray, width: number, height: number, file: string, fields: FabricFields | null = null): Artwork {
  requireSize(width, height, file);
  const weaves = fields?.weaves ?? {};
  const colours = Object.keys(weaves).map(plainHex);
  const pixels = pixelCounts(rgba);
  if (colours.length > 0) requireNamed(pixels, colours, fields?.artwork?.nearest ?? false, file);
  else colours.push(...foundColours(pixels, file));
  // Which of the colours each one is that the picture has.
  const codes = colours.map(codeOf);
  const named = new Uint8Array(ALL_COLOURS).fill(MAX_COLOURS);
  for (const [at, code] of codes.entries()) named[code] = at;
  const index = new Uint8Array(width * height);
  for (let row = 0, at = 0; row < height; row++)
    for (let end = 0, to = (height - 1 - row) * width; end < width; end++, at++, to++) {
      const code = codeAt(rgba, at);
      if (named[code] === MAX_COLOURS) named[code] = nearestOf(code, codes);
      index[to] = named[code]!;
    }
  return { ends: width, rows: height, colours, index, drafts: {} };
}

/** How many colours a picture has. */
export function colourCount(rgba: Uint8ClampedArray): number {
  return pixelCounts(rgba).reduce((sum, pixels) => sum + (pixels > 0 ? 1 : 0), 0);
}

/** Weaves to begin with, by colour: the darker it is to the eye, the more of the warp shows. */
export function firstWeaves(artwork: Artwork): Record<string, string> {
  const codes = artwork.colours.map(codeOf);
  const brightness = (code: number): number => luma([(code >> 16) / 255, ((code >> 8) & 255) / 255, (code & 255) / 255]);
  const order = codes.map((_, at) => at).sort((a, b) => brightness(codes[b]!) - brightness(codes[a]!) || a - b);
  const shades = codes.length > SHADES.length ? MANY_SHADES : SHADES;
  const found: Record<string, string> = {};
  for (const [at, colour] of artwork.colours.entries()) {
    const rank = order.indexOf(at) / Math.max(codes.length - 1, 1);
    found[colour] = shades[Math.round(rank * (shades.length - 1))]!;
  }
  return found;
}

/** Colours of the artwork and the share of its pixels that each has, in their order. */
export function colourShares({ index, colours }: Artwork): number[] {
  return pixelsOf(index, colours.length).map((pixels) => pixels / index.length);
}

/** The artwork's pixels [rows·ends·4], top row first, sRGB-encoded, opaque. */
export function pixelsOfArtwork({ ends, rows, colours, index }: Artwork): Uint8ClampedArray<ArrayBuffer> {
  const rgba = new Uint8ClampedArray(4 * ends * rows).fill(255);
  const codes = colours.map(codeOf);
  for (let row = 0, to = 0; row < rows; row++)
    for (let end = 0, at = (rows - 1 - row) * ends; end < ends; end++, at++, to += 4) {
      const code = codes[index[at]!]!;
      rgba[to] = code >> 16;
      rgba[to + 1] = (code >> 8) & 255;
      rgba[to + 2] = code & 255;
    }
  return rgba;
}

function codeAt(rgba: Uint8ClampedArray, at: number): number {
  const alpha = rgba[4 * at + 3]!;
  if (alpha === 255) return (rgba[4 * at]! << 16) | (rgba[4 * at + 1]! << 8) | rgba[4 * at + 2]!;
  const onWhite = (level: number): number => rint(level * (alpha / 255) + 255 * (1 - alpha / 255));
  return (onWhite(rgba[4 * at]!) << 16) | (onWhite(rgba[4 * at + 1]!) << 8) | onWhite(rgba[4 * at + 2]!);
}

/** How many pixels have each colour of 24 bits. */
function pixelCounts(rgba: Uint8ClampedArray): Uint32Array {
  const counts = new Uint32Array(ALL_COLOURS);
  for (let at = 0; at < rgba.length / 4; at++) counts[codeAt(rgba, at)]!++;
  return counts;
}

/** The colours that there are, those of most pixels first. */
function foundColours(pixels: Uint32Array, file: string): string[] {
  const found: number[] = [];
  for (let code = 0; code < ALL_COLOURS; code++) if (pixels[code]! > 0) found.push(code);
  if (found.length > MAX_COLOURS)
    throw new InputError(
      `${file} has ${found.length} colours, and ${MAX_COLOURS} at most can be weaves: reduce the picture to few colours ` +
        "without smoothing (an indexed PNG).",
    );
  return found.sort((a, b) => pixels[b]! - pixels[a]! || a - b).map(hexOfCode);
}

function requireNamed(pixels: Uint32Array, colours: readonly string[], nearest: boolean, file: string): void {
  if (nearest) return;
  const codes = new Set(colours.map(codeOf));
  const others = new Map<number, number>();
  for (let code = 0; code < ALL_COLOURS; code++) if (pixels[code]! > 0 && !codes.has(code)) others.set(code, pixels[code]!);
  if (others.size > 0) throw unnamed(file, colours, others);
}
