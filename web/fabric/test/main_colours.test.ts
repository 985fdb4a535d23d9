/** Pictures in their main colours. */
import { expect, test } from "vitest";

import { inMainColours } from "../src/main_colours.ts";

type Rgb = readonly [number, number, number];
const SIDE = 48;

/** Red left, white right of a smooth edge, a navy disc; as a drawing program saves it, with noise of a level or two. */
function drawing(): Uint8ClampedArray<ArrayBuffer> {
  const mixed = (one: Rgb, other: Rgb, share: number): number[] => one.map((level, channel) => level + share * (other[channel]! - level));
  const [red, white, navy]: Rgb[] = [[192, 16, 8], [250, 250, 246], [10, 16, 64]];
  const rgba = new Uint8ClampedArray(4 * SIDE * SIDE).fill(255);
  for (let row = 0, at = 0; row < SIDE; row++)
    for (let column = 0; column < SIDE; column++, at++) {
      const ground = mixed(red!, white!, Math.min(Math.max((column - 23) / 2, 0), 1));
      const inside = Math.min(Math.max(10 - Math.hypot(row - 24, column - 12), 0), 1);
      const noise = ((7 * row + 13 * column) % 5) - 2;
      rgba.set(mixed(ground as unknown as Rgb, navy!, inside).map((level) => level + noise), 4 * at);
    }
  return rgba;
}

const coloursOf = (rgba: Uint8ClampedArray): Set<number> =>
  new Set(Array.from({ length: rgba.length / 4 }, (_, at) => (rgba[4 * at]! << 16) | (rgba[4 * at + 1]! << 8) | rgba[4 * at + 2]!));

test("a drawing with smooth edges has the colours that were painted", () => {
  const rgba = drawing();
  expect(coloursOf(rgba).size).toBeGreaterThan(30);
  const found = inMainColours(rgba, SIDE, SIDE, 3);
  const colours = [...coloursOf(found)];
  expect(colours).toHaveLength(3);
  for (const [red, green, blue] of [[192, 16, 8], [250, 250, 246], [10, 16, 64]])
    expect(Math.min(...colours.map((code) => Math.max(Math.abs((code >> 16) - red!), Math.abs(((code >> 8) & 255) - green!), Math.abs((code & 255) - blue!))))).toBeLessThan(16);
  // The disc of radius 10 and the half right of the edge, each within the pixels of its edge.
  const share = (isOne: (red: number, blue: number) => boolean): number =>
    Array.from({ length: SIDE * SIDE }, (_, at) => isOne(found[4 * at]!, found[4 * at + 2]!)).filter(Boolean).length / SIDE ** 2;
  expect(Math.abs(share((red) => red < 100) - (Math.PI * 90) / SIDE ** 2)).toBeLessThan(0.03);
  expect(Math.abs(share((_, blue) => blue > 200) - 0.5)).toBeLessThan(0.03);
});

test("fewer colours than asked for stay as they are, and a pixel by itself goes", () => {
  const rgba = new Uint8ClampedArray(4 * 64).fill(255);
  for (let at = 0; at < 32; at++) rgba.set([200, 0, 0], 4 * at);
  const two = rgba.slice();
  rgba.set([0, 0, 90], 4 * 20);
  expect(inMainColours(two, 8, 8, 6)).toEqual(two);
  expect(inMainColours(rgba, 8, 8, 6)).toEqual(two);
});

test("what is transparent is white", () => {
  const rgba = new Uint8ClampedArray(4 * 16);
  for (let at = 0; at < 8; at++) rgba.set([200, 0, 0, 255], 4 * at);
  expect([...inMainColours(rgba, 4, 4, 2).subarray(32, 36)]).toEqual([255, 255, 255, 255]);
});
