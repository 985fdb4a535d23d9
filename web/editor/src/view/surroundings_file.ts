/** Surroundings from a picture of the user's own (Radiance .hdr), read by three.js' loader. */
import { InputError } from "loomlight-fabric";

import type { SurroundingsPicture } from "./cloth_view.ts";

/** 8192 × 4096 pixels at four bytes each, which are more than light needs. */
const LARGEST = 128 * 2 ** 20;
/** Wider pictures light cloth no better. */
const WIDEST = 512;

/**
 * The picture in a file, brought down to a width that lights cloth as well.
 *
 * @throws InputError one that is too large, no such picture, or one that is not twice as wide as high.
 */
export async function readSurroundings(file: File): Promise<SurroundingsPicture> {
  if (file.size > LARGEST)
    throw new InputError(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB; surroundings of up to ${LARGEST >> 20} MiB are read.`);
  const { HDRLoader } = await import("three/addons/loaders/HDRLoader.js");
  const { FloatType } = await import("three");
  let read: { width: number; height: number; data: ArrayLike<number> };
  try {
    read = new HDRLoader().setDataType(FloatType).parse(await file.arrayBuffer()) as typeof read;
  } catch {
    throw new InputError(`${file.name} is damaged or no Radiance picture (.hdr).`);
  }
  if (Math.abs(read.width - 2 * read.height) > 2)
    throw new InputError(`${file.name} has ${read.width} × ${read.height} pixels: surroundings are twice as wide as high.`);
  return reduced(read);
}

function reduced({ width, height, data }: { width: number; height: number; data: ArrayLike<number> }): SurroundingsPicture {
  const by = Math.max(1, Math.ceil(width / WIDEST));
  const [columns, rows] = [Math.floor(width / by), Math.floor(height / by)];
  const pixels = new Float32Array(columns * rows * 3);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++)
      for (let axis = 0; axis < 3; axis++) {
        let sum = 0;
        for (let dy = 0; dy < by; dy++)
          for (let dx = 0; dx < by; dx++) sum += data[((row * by + dy) * width + column * by + dx) * 4 + axis]!;
        pixels[(row * columns + column) * 3 + axis] = sum / (by * by);
      }
  return { width: columns, height: rows, pixels };
}
