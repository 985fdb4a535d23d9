/** Albedo maps for shaders: a pyramid of means of a picture, packed into words; see `realtime/scene.py`. */
import { clamp, InputError, rint } from "loomlight-fabric";

import { MAX_SIDE, ROOT_STEPS } from "../generated.ts";
import type { LinearPicture } from "../types.ts";

/** Words of all levels, the finest first, and their number: square roots of red, green, blue in ten bits each. */
export function mapWords(picture: LinearPicture): { words: Uint32Array; levels: number } {
  requirePicture(picture, "albedo");
  const side = Math.min(MAX_SIDE, 2 ** Math.ceil(Math.log2(Math.max(picture.width, picture.height))));
  let level = resized(picture, side);
  const parts = [packed(level)];
  for (let size = side; size > 1; size /= 2) {
    level = halved(level, size);
    parts.push(packed(level));
  }
  const words = new Uint32Array(parts.reduce((sum, part) => sum + part.length, 0));
  let first = 0;
  for (const part of parts) {
    words.set(part, first);
    first += part.length;
  }
  return { words, levels: parts.length };
}

/** @throws InputError a picture without pixels, or whose numbers are not those of its size. */
export function requirePicture(picture: LinearPicture, what: string): void {
  const { width, height, pixels } = picture;
  if (!(width >= 1 && height >= 1 && pixels.length === 3 * width * height))
    throw new InputError(`${what} of ${width} × ${height} pixels holds ${pixels.length} numbers: it is no picture.`);
}

/** A square of `side` pixels, 0 to 1. */
function resized({ width, height, pixels }: LinearPicture, side: number): Float32Array {
  const shrinks = side <= Math.min(width, height);
  const clipped = Float32Array.from(pixels, (value) => clamp(value, 0, 1));
  if (width === side && height === side) return clipped;
  const columns = taps(width, side, shrinks);
  const rows = taps(height, side, shrinks);
  const wide = new Float32Array(3 * side * height);
  for (let row = 0; row < height; row++)
    columns.forEach(([first, weights], column) => {
      for (let channel = 0; channel < 3; channel++) {
        let sum = 0;
        weights.forEach((weight, k) => (sum += weight * clipped[3 * (row * width + first + k) + channel]!));
        wide[3 * (row * side + column) + channel] = sum;
      }
    });
  const square = new Float32Array(3 * side * side);
  rows.forEach(([first, weights], row) => {
    for (let i = 0; i < 3 * side; i++) {
      let sum = 0;
      weights.forEach((weight, k) => (sum += weight * wide[3 * (first + k) * side + i]!));
      square[3 * row * side + i] = sum;
    }
  });
  return square;
}

/** First pixel and weights of each of `to` pixels, made from `from` ones, by a box or a triangle, as Pillow does. */
function taps(from: number, to: number, isBox: boolean): [number, number[]][] {
  const step = from / to;
  const wide = Math.max(step, 1);
  const support = (isBox ? 0.5 : 1) * wide;
  return Array.from({ length: to }, (_, pixel) => {
    const centre = (pixel + 0.5) * step;
    const first = Math.max(0, Math.trunc(centre - support + 0.5));
    const last = Math.min(from, Math.trunc(centre + support + 0.5));
    const weights = Array.from({ length: last - first }, (_, k) => {
      const place = (k + first - centre + 0.5) / wide;
      return isBox ? (place > -0.5 && place <= 0.5 ? 1 : 0) : Math.max(0, 1 - Math.abs(place));
    });
    const total = weights.reduce((sum, weight) => sum + weight, 0);
    return [first, weights.map((weight) => weight / total)];
  });
}

function halved(level: Float32Array, size: number): Float32Array {
  const half = size / 2;
  const result = new Float32Array(3 * half * half);
  for (let row = 0; row < half; row++)
    for (let column = 0; column < half; column++)
      for (let channel = 0; channel < 3; channel++) {
        const at = 3 * (2 * row * size + 2 * column) + channel;
        result[3 * (row * half + column) + channel] =
          (level[at]! + level[at + 3]! + level[at + 3 * size]! + level[at + 3 * size + 3]!) / 4;
      }
  return result;
}

function packed(level: Float32Array): Uint32Array {
  return Uint32Array.from({ length: level.length / 3 }, (_, texel) => {
    const [red, green, blue] = [0, 1, 2].map((channel) => rint(Math.sqrt(level[3 * texel + channel]!) * ROOT_STEPS)) as [
      number,
      number,
      number,
    ];
    return red | (green << 10) | (blue << 20);
  });
}
