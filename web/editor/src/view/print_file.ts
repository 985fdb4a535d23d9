/** A picture that is printed on the cloth: the shaders' albedo map, and the flat view's pattern. */
import { InputError, srgbToLinear } from "loomlight-fabric";

import type { Print } from "./cloth_view.ts";

/** Larger files are refused before they are decoded. */
const MAX = 64 * 2 ** 20;
/** Longer sides are brought down to that. */
const MAX_SIDE = 1024;

/**
 * The picture in a file, in linear RGB.
 *
 * @throws InputError one that is too large, or none that the browser reads.
 */
export async function readPrint(file: File): Promise<Print> {
  if (file.size > MAX)
    throw new InputError(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB; prints of up to ${MAX >> 20} MiB are read.`);
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(file);
  } catch {
    throw new InputError(`${file.name} is no picture that this browser reads: save it as PNG or JPEG.`);
  }
  const shrink = Math.min(1, MAX_SIDE / Math.max(bitmap.width, bitmap.height));
  const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.max(1, Math.round(side * shrink))) as [number, number];
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  // What is transparent stays as it was woven.
  context.fillStyle = "#fff";
  context.fillRect(0, 0, width, height);
  context.drawImage(bitmap, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  const linear = Float32Array.from({ length: 256 }, (_, code) => srgbToLinear(code / 255));
  const pixels = new Float32Array(3 * width * height);
  for (let pixel = 0; pixel < width * height; pixel++)
    for (let axis = 0; axis < 3; axis++) pixels[3 * pixel + axis] = linear[data[4 * pixel + axis]!]!;
  return { name: file.name, canvas, picture: { width, height, pixels } };
}
