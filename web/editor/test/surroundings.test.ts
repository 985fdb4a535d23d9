import { describe, expect, it } from "vitest";

import { FIRST_SCENE } from "../src/state/document.ts";
import { lampOf, surroundingsOf } from "../src/view/surroundings.ts";
import { readSurroundings } from "../src/view/surroundings_file.ts";

/** An uncompressed OpenEXR picture in luminance, from its rows, the top one first; see the OpenEXR file layout. */
function exr(rows: readonly (readonly number[])[]): Uint8Array<ArrayBuffer> {
  const [height, width] = [rows.length, rows[0]!.length];
  const bytes: number[] = [];
  const put = (size: number, write: (view: DataView) => void): void => {
    const view = new DataView(new ArrayBuffer(size));
    write(view);
    bytes.push(...new Uint8Array(view.buffer));
  };
  const int = (...values: number[]): void => values.forEach((value) => put(4, (view) => view.setInt32(0, value, true)));
  const float = (value: number): void => put(4, (view) => view.setFloat32(0, value, true));
  const text = (value: string): void => void bytes.push(...new TextEncoder().encode(value), 0);
  const attribute = (name: string, type: string, size: number, write: () => void): void => {
    text(name);
    text(type);
    int(size);
    write();
  };
  const box = (): void => int(0, 0, width - 1, height - 1);
  int(20000630, 2);
  attribute("channels", "chlist", 19, () => {
    text("Y");
    int(2, 0, 1, 1); // 32-bit float; linear; sampled at every pixel
    bytes.push(0);
  });
  attribute("compression", "compression", 1, () => bytes.push(0));
  attribute("dataWindow", "box2i", 16, box);
  attribute("displayWindow", "box2i", 16, box);
  attribute("lineOrder", "lineOrder", 1, () => bytes.push(0));
  attribute("pixelAspectRatio", "float", 4, () => float(1));
  attribute("screenWindowCenter", "v2f", 8, () => (float(0), float(0)));
  attribute("screenWindowWidth", "float", 4, () => float(1));
  bytes.push(0);
  const first = bytes.length + 8 * height;
  rows.forEach((_, row) => int(first + row * (8 + 4 * width), 0));
  rows.forEach((row, y) => {
    int(y, 4 * width);
    row.forEach(float);
  });
  return Uint8Array.from(bytes);
}

describe("the studio", () => {
  const { picture } = surroundingsOf(FIRST_SCENE, null)!;
  const pixels = Float32Array.from(picture.pixels);
  const lamp = lampOf(FIRST_SCENE)!;
  /** Of a card, over π: what a white one shows; rows from above, columns from the back over the right. */
  function shown(card: readonly number[]): number {
    let sum = 0;
    pixels.forEach((value, i) => {
      const place = Math.floor(i / 3);
      const polar = (Math.floor(place / picture.width) + 0.5) * (Math.PI / picture.height);
      const around = ((place % picture.width) + 0.5) * ((2 * Math.PI) / picture.width);
      const towards = [Math.sin(polar) * Math.sin(around), Math.cos(polar), -Math.sin(polar) * Math.cos(around)];
      const cosine = towards.reduce((found, part, axis) => found + part * card[axis]!, 0);
      sum += (Math.max(cosine, 0) * value * Math.sin(polar) * (Math.PI / picture.height) * 2 * Math.PI) / picture.width;
    });
    return sum / 3 / Math.PI;
  }

  it("shows a white card that faces its key light at a radiance of 1, as Python does", () => {
    expect(shown(lamp.towards) + lamp.irradiance![0] / Math.PI).toBeCloseTo(1, 5);
    const [x, y, z] = lamp.towards;
    // The dome is the same all around, the back light a quarter of the whole.
    const quarter = (shown([-x, y, -z]) - shown(lamp.towards)) / (lamp.irradiance![0] / Math.PI / 0.9);
    expect(quarter).toBeCloseTo(0.25, 3);
  });

  it("is grey, and paper throws light back from below", () => {
    expect(pixels.every((value, i) => value === pixels[i - (i % 3)])).toBe(true);
    const flat = shown([0, 1, 0]) + (lamp.towards[1] * lamp.irradiance![0]) / Math.PI;
    expect(shown([0, -1, 0])).toBeCloseTo(0.5 * 0.6 * flat, 3);
  });
});

describe("surroundings of the user's own", () => {
  it("have the top row of an OpenEXR picture first, and grey for luminance", async () => {
    const file = new File([exr([[1, 2, 3, 4], [5, 6, 7, 8]])], "sky.exr");
    const { width, height, pixels } = await readSurroundings(file);
    expect([width, height]).toEqual([4, 2]);
    expect([...pixels.slice(0, 6)]).toEqual([1, 1, 1, 2, 2, 2]);
    expect([...pixels.slice(-3)]).toEqual([8, 8, 8]);
  });

  it("are twice as wide as high", async () => {
    const file = new File([exr([[1], [2], [3], [4]])], "door.exr");
    await expect(readSurroundings(file)).rejects.toThrow("door.exr has 1 × 4 pixels: surroundings are twice as wide");
  });
});
