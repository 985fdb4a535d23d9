/** Surroundings from a picture of the user's own (Radiance .hdr or OpenEXR), read by three.js' loaders. */
import { InputError } from "loomlight-fabric";

import type { SurroundingsPicture } from "./cloth_view.ts";

/** 8192 × 4096 pixels at four bytes each, which are more than light needs. */
const MAX = 128 * 2 ** 20;
/** Wider pictures light cloth no better. */
const WIDEST = 512;

/**
 * The picture in a file, brought down to a width that lights cloth as well.
 *
 * @throws InputError one that is too large, no such picture, or one that is not twice as wide as high.
 */
export async function readSurroundings(file: File): Promise<SurroundingsPicture> {
  if (file.size > MAX)
    throw new InputError(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB; surroundings of up to ${MAX >> 20} MiB are read.`);
  const { FloatType } = await import("three");
  let read: { width: number; height: number; data: ArrayLike<number> };
  let isTopFirst = true;
  try {
    const content = await file.arrayBuffer();
    if (/\.exr$/i.test(file.name)) {
      const { EXRLoader } = await import("three/addons/loaders/EXRLoader.js");
      read = new EXRLoader().setDataType(FloatType).parse(content) as typeof read;
      isTopFirst = false;
    } else {
      const { HDRLoader } = await import("three/addons/loaders/HDRLoader.js");
      read = new HDRLoader().setDataType(FloatType).parse(content) as typeof read;
    }
  } catch {
    throw new InputError(`${file.name} is damaged or no picture of surroundings (.hdr or .exr).`);
  }
  if (Math.abs(read.width - 2 * read.height) > 2)
    throw new InputError(`${file.name} has ${read.width} × ${read.height} pixels: surroundings are twice as wide as high.`);
  return reduced(read, isTopFirst);
}

function reduced(
  { width, height, data }: { width: number; height: number; data: ArrayLike<number> },
  isTopFirst: boolean,
): SurroundingsPicture {
  const by = Math.max(1, Math.ceil(width / WIDEST));
  const [columns, rows] = [Math.floor(width / by), Math.floor(height / by)];
  // Pictures of luminance alone have one number a pixel.
  const channels = data.length / (width * height);
  const at = (x: number, y: number, axis: number): number =>
    data[((isTopFirst ? y : height - 1 - y) * width + x) * channels + Math.min(axis, channels - 1)]!;
  const pixels = new Float32Array(columns * rows * 3);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++)
      for (let axis = 0; axis < 3; axis++) {
        let sum = 0;
        for (let dy = 0; dy < by; dy++)
          for (let dx = 0; dx < by; dx++) sum += at(column * by + dx, row * by + dy, axis);
        pixels[(row * columns + column) * 3 + axis] = sum / (by * by);
      }
  return { width: columns, height: rows, pixels };
}
