import { describe, expect, test } from "vitest";

import { whiteBalance } from "../src/index.ts";

/** As `loomlight.core.colour.white_balance` has them. */
const OF_PYTHON = [
  [2000, [0.08257, 0.32232, 10.41446]],
  [3200, [0.50802, 0.98315, 2.61564]],
  [4000, [0.67774, 1.00518, 1.89758]],
  [5500, [0.90139, 1.00805, 1.21061]],
  [9000, [1.15375, 0.9792, 0.75329]],
] as const;

describe("white balance", () => {
  test.each(OF_PYTHON)("%d K", (kelvin, gains) => {
    whiteBalance(kelvin).forEach((gain, channel) => expect(gain).toBeCloseTo(gains[channel]!, 4));
  });

  test("daylight stays as it is", () => {
    expect(whiteBalance(6500)).toEqual([1, 1, 1]);
  });
});
