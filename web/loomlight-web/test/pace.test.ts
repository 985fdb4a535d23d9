/** How fine pictures are, and in what areas they are made, on adapters of known speed. */
import { expect, it } from "vitest";

import { areasOf, pixelsOf, taken } from "../src/areas.ts";
import { Pace } from "../src/pace.ts";

const FULL = 1000 * 800;
const BUDGET = { moving: 30, submission: 200, resting: 60_000 };

/** Divisors of pictures until the finest of one submission, on an adapter that takes so long for a pixel. */
function divisors(msOfPixel: number): number[] {
  const pace = new Pace(BUDGET);
  for (let pass = 0; pass < 20; pass++) pace.measured(msOfPixel * pace.pixels, pace.pixels);
  pace.moved(FULL);
  const found = [pace.divisor];
  while (pace.rested(FULL)) found.push(pace.divisor);
  return found;
}

it("shows a fast adapter's pictures as fine as the canvas at once", () => expect(divisors(1e-5)).toEqual([1]));

it("refines at rest by halves, as far as a pass is one submission", () => {
  expect(divisors(1e-3)).toEqual([6, 3, 2]);
  expect(divisors(0.1)).toEqual([16]);
});

it("takes no more pixels at a time than the budget of a submission", () => {
  const pace = new Pace(BUDGET);
  const [overhead, cost] = [20, 0.08];
  for (let pass = 0; pass < 40; pass++) {
    const { pixels } = pace;
    pace.measured(overhead + cost * pixels, pixels);
    expect(overhead + cost * pixels).toBeLessThanOrEqual(2 * BUDGET.submission);
  }
  const usual = pace.pixels;
  expect(usual).toBeGreaterThan(1024);
  // A dear part counts at once, a cheap one by and by.
  pace.measured(8 * (overhead + cost * usual), usual);
  const after = pace.pixels;
  expect(after).toBeLessThan(0.6 * usual);
  pace.measured(overhead + cost * after, after);
  expect(pace.pixels).toBeLessThan(usual);
});

it("makes one pass on the slowest adapter, and as many as there is time for on others", () => {
  const pace = new Pace(BUDGET);
  expect(pace.passes(FULL, 256)).toBe(256);
  for (let pass = 0; pass < 20; pass++) pace.measured(0.1 * pace.pixels, pace.pixels);
  expect(pace.passes(FULL, 256)).toBe(1);
  expect(pace.passes(50_000, 256)).toBeGreaterThan(6);
});

it("makes areas of a whole picture, the middle first, each pixel once", () => {
  const [width, height] = [103, 57];
  const areas = areasOf(width, height, 400);
  expect(Math.hypot(areas[0]!.x + areas[0]!.width / 2 - width / 2, areas[0]!.y + areas[0]!.height / 2 - height / 2)).toBeLessThan(20);
  const drawn = new Uint8Array(width * height);
  const sizes = [1000, 90, 7, 400];
  for (let turn = 0; areas.length > 0; turn++) {
    const most = sizes[turn % sizes.length]!;
    const next = taken(areas, most);
    expect(next.reduce((sum, area) => sum + pixelsOf(area), 0)).toBeLessThanOrEqual(most);
    for (const { x, y, width: across, height: down } of next)
      for (let row = y; row < y + down; row++) for (let column = x; column < x + across; column++) drawn[row * width + column]!++;
  }
  expect(drawn.every((times) => times === 1)).toBe(true);
});
