import { readFileSync } from "node:fs";

import { describe, expect, it } from "vitest";

import { InputError, yarnTex } from "../src/index.ts";

/** The table that the Python package is tested with too. */
const TABLE = JSON.parse(readFileSync(new URL("../../../tests/cases/yarn_counts.json", import.meta.url), "utf8")) as {
  readonly tex: Record<string, number>;
  readonly refused: Record<string, string>;
};

describe("yarn counts", () => {
  it.each(Object.entries(TABLE.tex))("%j is %d tex", (count, tex) => {
    // The table has eight digits.
    expect(Math.abs(yarnTex(count) / tex - 1)).toBeLessThan(1e-6);
  });

  it.each(Object.entries(TABLE.refused))("%j is refused", (count, sentence) => {
    expect(() => yarnTex(count)).toThrow(new InputError(sentence));
  });
});
