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

/** The picture of one repeat. */
export function clothPicture(draft: Draft, options: PictureOptions): ClothPicture {
  const { pixels, gap } = options;
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
