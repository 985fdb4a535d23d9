/** Environments: equirectangular radiance, and the tables by which shaders choose directions from it. */
import { InputError } from "loomlight-fabric";

import { MAX_COLUMNS } from "../generated.ts";
import type { Environment, LinearPicture } from "../types.ts";
import { requirePicture } from "./albedo_map.ts";

export interface EnvironmentTables {
  readonly rows: number;
  readonly columns: number;
  /** Integral of the mean of red, green and blue over the sphere. */
  readonly total: number;
  /** Distributions of rows and of columns within each, then radiance, as shaders read them. */
  readonly words: Uint32Array;
}

/**
 * Tables of an environment of at most 1024 columns; larger ones are averaged.
 *
 * @throws InputError radiance that is negative or not finite.
 */
export function environmentTables({ picture }: Environment): EnvironmentTables {
  requirePicture(picture, "environment");
  for (let i = 0; i < picture.pixels.length; i++)
    if (!(picture.pixels[i]! >= 0 && picture.pixels[i]! < Infinity))
      throw new InputError("The environment holds radiance that is negative or no finite number.");
  const { width: columns, height: rows, pixels } = atMost(picture, MAX_COLUMNS);
  const byRow = new Float64Array(rows);
  const weights = new Float64Array(rows * columns);
  for (let row = 0; row < rows; row++) {
    const [upper, lower] = [Math.cos((row / rows) * Math.PI), Math.cos(((row + 1) / rows) * Math.PI)];
    const solidAngle = (upper - lower) * ((2 * Math.PI) / columns);
    for (let column = 0; column < columns; column++) {
      const at = row * columns + column;
      const mean = (pixels[3 * at]! + pixels[3 * at + 1]! + pixels[3 * at + 2]!) / 3;
      weights[at] = mean * solidAngle;
      byRow[row]! += weights[at]!;
    }
  }
  const numbers = new Float32Array(rows + 1 + rows * (columns + 1) + 3 * rows * columns);
  numbers.set(distribution(byRow), 0);
  for (let row = 0; row < rows; row++)
    numbers.set(
      distribution(weights.subarray(row * columns, (row + 1) * columns)),
      rows + 1 + row * (columns + 1),
    );
  numbers.set(pixels as ArrayLike<number>, rows + 1 + rows * (columns + 1));
  const total = byRow.reduce((sum, weight) => sum + weight, 0);
  return { rows, columns, total, words: new Uint32Array(numbers.buffer) };
}

/** Cumulative distribution from 0 to 1; uniform where all weights are 0. */
function distribution(weights: Float64Array): Float64Array {
  const sums = new Float64Array(weights.length + 1);
  for (let i = 0; i < weights.length; i++) sums[i + 1] = sums[i]! + weights[i]!;
  const total = sums[weights.length]!;
  return sums.map((sum, i) => (total > 0 ? sum / total : i / weights.length));
}

/** Means over equal groups of pixels, so that there are at most so many columns; edges are repeated. */
function atMost(picture: LinearPicture, columns: number): LinearPicture {
  const step = Math.ceil(picture.width / columns);
  if (step === 1) return picture;
  const [width, height] = [Math.ceil(picture.width / step), Math.ceil(picture.height / step)];
  const pixels = new Float64Array(3 * width * height);
  for (let row = 0; row < height * step; row++)
    for (let column = 0; column < width * step; column++) {
      const from = Math.min(row, picture.height - 1) * picture.width + Math.min(column, picture.width - 1);
      const to = Math.floor(row / step) * width + Math.floor(column / step);
      for (let channel = 0; channel < 3; channel++)
        pixels[3 * to + channel]! += picture.pixels[3 * from + channel]! / (step * step);
    }
  return { width, height, pixels };
}
