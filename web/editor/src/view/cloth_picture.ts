/**
 * A picture of a draft as woven yarns, without a GPU: round yarns in their colours, lit from above left.
 *
 * It shows structure and colours where WebGPU is missing, and in tiles; it is no rendering of the fabric's light.
 */
import type { Draft } from "loomlight-fabric";
import { linearToSrgb } from "loomlight-fabric";

export interface ClothPicture {
  readonly width: number;
  readonly height: number;
  /** sRGB [height·width·4], the top row first. */
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

export interface PictureOptions {
  /** Pixels a thread, each way. */
  readonly pixels: number;
  /** Share of a thread's spacing that stays open, of warp and weft. */
  readonly gap: { readonly warp: number; readonly weft: number };
}

/** Where the light comes from: right, up, out of the cloth. */
const LIGHT = [-0.42, 0.5, 0.76] as const;
const GROUND = 0.012;

/** The picture of one repeat; of one pixel a thread, the colours of what is on top. */
export function clothPicture(draft: Draft, options: PictureOptions): ClothPicture {
  const { pixels, gap } = options;
  if (pixels === 1) return farPicture(draft, gap);
  const { ends, picks, drawdown } = draft;
  const width = ends * pixels;
  const height = picks * pixels;
  const rgba = new Uint8ClampedArray(width * height * 4);
  const warp = floatsOf(draft, true);
  const weft = floatsOf(draft, false);
  const at = (index: number): number => ((index + 0.5) / pixels) * 2 - 1;
  for (let pick = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++) {
      const cell = pick * ends + end;
      const isWarp = drawdown[cell] === 1;
      for (let row = 0; row < pixels; row++)
        for (let column = 0; column < pixels; column++) {
          const [x, y] = [at(column), at(row)];
          const colour = coverOf(isWarp, x, y, gap)
            ? shade(draft, isWarp, isWarp ? end : pick, x, y, isWarp ? warp[cell]! : weft[cell]!, gap)
            : coverOf(!isWarp, x, y, gap)
              ? below(draft, !isWarp, isWarp ? pick : end, x, y, gap)
              : [GROUND, GROUND, GROUND];
          const place = ((height - 1 - (pick * pixels + row)) * width + end * pixels + column) * 4;
          rgba[place] = 255 * linearToSrgb(colour[0]!);
          rgba[place + 1] = 255 * linearToSrgb(colour[1]!);
          rgba[place + 2] = 255 * linearToSrgb(colour[2]!);
          rgba[place + 3] = 255;
        }
    }
  return { width, height, rgba };
}

/** One pixel a crossing: the thread on top in the mean shade of a float of three. */
function farPicture(draft: Draft, gap: PictureOptions["gap"]): ClothPicture {
  const { ends, picks, drawdown } = draft;
  const rgba = new Uint8ClampedArray(ends * picks * 4);
  const words = new Uint32Array(rgba.buffer);
  const [warp, weft] = [farColours(draft, true, ends, gap), farColours(draft, false, picks, gap)];
  for (let pick = 0, cell = 0; pick < picks; pick++)
    for (let end = 0, place = (picks - 1 - pick) * ends; end < ends; end++, cell++, place++)
      words[place] = drawdown[cell] === 1 ? warp[end]! : weft[pick]!;
  return { width: ends, height: picks, rgba };
}

/** Pixels of the threads of a family, as words of a picture. */
function farColours(draft: Draft, isWarp: boolean, count: number, gap: PictureOptions["gap"]): Uint32Array {
  const found = new Uint8ClampedArray(4 * count).fill(255);
  const places = [-0.75, -0.25, 0.25, 0.75];
  for (let thread = 0; thread < count; thread++) {
    const shades = places.flatMap((x) => places.map((y) => shade(draft, isWarp, thread, x, y, [-1, 3], gap)));
    for (let channel = 0; channel < 3; channel++)
      found[4 * thread + channel] = 255 * linearToSrgb(shades.reduce((sum, colour) => sum + colour[channel]!, 0) / shades.length);
  }
  return new Uint32Array(found.buffer);
}

function coverOf(isWarp: boolean, x: number, y: number, gap: PictureOptions["gap"]): boolean {
  return Math.abs(isWarp ? x : y) <= 1 - (isWarp ? gap.warp : gap.weft);
}

/** Where each crossing lies in its float: start of the float relative to the crossing, and its length, in threads. */
type Float = readonly [number, number];

function floatsOf(draft: Draft, isWarp: boolean): Float[] {
  const { ends, picks, drawdown } = draft;
  const [lines, count] = isWarp ? [ends, picks] : [picks, ends];
  const cell = (line: number, index: number): number =>
    isWarp ? (index % count) * ends + line : line * ends + (index % count);
  const floats = new Array<Float>(ends * picks).fill([0, 1]);
  for (let line = 0; line < lines; line++) {
    const isTop = (index: number): boolean => (drawdown[cell(line, index)] === 1) === isWarp;
    let start = 0;
    while (start < count && isTop(start) === isTop(start + count - 1)) start++;
    if (start === count) start = 0;
    for (let index = start; index < start + count; ) {
      let length = 1;
      while (length < count && isTop(index + length) === isTop(index)) length++;
      for (let offset = 0; offset < length; offset++) floats[cell(line, index + offset)] = [-offset, length];
      index += length;
    }
  }
  return floats;
}

/** Colour of a thread on top: a cylinder that dives at the ends of its float. */
function shade(
  draft: Draft,
  isWarp: boolean,
  thread: number,
  x: number,
  y: number,
  [start, length]: Float,
  gap: PictureOptions["gap"],
): [number, number, number] {
  const across = (isWarp ? x : y) / (1 - (isWarp ? gap.warp : gap.weft));
  const along = (((isWarp ? y : x) + 1) / 2 - start) / length; // 0 to 1 over the float
  const slope = Math.sign(along - 0.5) * Math.abs(2 * along - 1) ** Math.max(2, length * 2) * 0.9;
  const side = across * 0.92;
  const normal = isWarp ? [side, slope, 1] : [slope, side, 1];
  const size = Math.hypot(normal[0]!, normal[1]!, normal[2]!);
  const facing = (normal[0]! * LIGHT[0] + normal[1]! * LIGHT[1] + normal[2]! * LIGHT[2]) / size;
  const twist = 0.06 * Math.sin((across * 1.1 + (isWarp ? y : x) * 1.6) * 9);
  const diffuse = Math.max(facing, 0) * (0.95 + twist);
  const occlusion = 1 - 0.45 * Math.abs(2 * along - 1) ** Math.max(3, length * 3) - 0.2 * across ** 4;
  const gleam = 0.1 * Math.max(facing, 0) ** 18;
  return colourOf(draft, isWarp, thread, (0.16 + 0.9 * diffuse) * occlusion, gleam * occlusion);
}

/** Colour of a thread seen through the gaps of the one above it: in shadow. */
function below(
  draft: Draft,
  isWarp: boolean,
  thread: number,
  x: number,
  y: number,
  gap: PictureOptions["gap"],
): [number, number, number] {
  const across = (isWarp ? x : y) / (1 - (isWarp ? gap.warp : gap.weft));
  return colourOf(draft, isWarp, thread, 0.3 * (1 - 0.5 * across ** 2), 0);
}

function colourOf(draft: Draft, isWarp: boolean, thread: number, light: number, gleam: number): [number, number, number] {
  const colors = (isWarp ? draft.warp : draft.weft).colors!;
  return [
    colors[thread * 3]! * light + gleam,
    colors[thread * 3 + 1]! * light + gleam,
    colors[thread * 3 + 2]! * light + gleam,
  ];
}
