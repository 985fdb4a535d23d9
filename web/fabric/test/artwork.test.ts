/** [weaves] and [artwork] of a fabric file: the page keeps them, and counts the picks that take up cloth. */
import { expect, test } from "vitest";

import { PLAIN_THREADS, type Draft } from "../src/draft.ts";
import { familySpacing, withoutArtwork } from "../src/spacing.ts";
import { readToml, writeToml } from "../src/toml.ts";

const TEXT = `image = "art.png"
picks_per_cm = 24

[weaves]
"#c00000" = ["plain", "sateen 8/3"]
"#FFF" = ["plain", "back"]

[artwork]
order = "1 2"
regulator = 2
`;

test("an artwork is written as it was read", () => {
  expect(writeToml(readToml(TEXT))).toBe(TEXT);
});

test("weaves that are none are refused in a sentence", () => {
  for (const bad of ["8", "[]", '""', '["plain", ""]', "{}"])
    expect(() => readToml(`image = "a.png"\n[weaves]\n"#fff" = ${bad}\n`)).toThrow(/weaves\."#fff" (names no weave: write one|lists 0 weaves)/);
  expect(() => readToml('image = "a.png"\nweaves = "plain"\n')).toThrow(/weaves is no table/);
});

test("picks per centimetre are those that take up cloth", () => {
  const weft = { ...PLAIN_THREADS, spacingMm: Float64Array.of(1, 1, 0.5, 0.5), colorIndex: Int32Array.of(1, 1, 1, 2) };
  const draft = { ends: 2, picks: 4, warp: PLAIN_THREADS, weft } as unknown as Draft;
  const spacing = familySpacing(readToml(TEXT), "weft", draft);
  expect([...spacing].reduce((sum, each) => sum + each, 0)).toBeCloseTo((3 * 10) / 24, 9);
});

test("a draft that stands by itself is the same cloth", () => {
  const weft = { ...PLAIN_THREADS, spacingMm: Float64Array.of(1, 1, 0.5, 0.5), colorIndex: Int32Array.of(1, 1, 1, 2) };
  const draft = { ends: 2, picks: 4, warp: PLAIN_THREADS, weft } as unknown as Draft;
  for (const text of [TEXT, TEXT.replace("picks_per_cm = 24", "ppi = 60"), TEXT.replace("picks_per_cm = 24\n", "")]) {
    const fields = readToml(text);
    const kept = withoutArtwork(fields, draft);
    expect(kept.weaves).toBeUndefined();
    familySpacing(kept, "weft", draft).forEach((spacing, pick) =>
      expect(spacing).toBeCloseTo(familySpacing(fields, "weft", draft)[pick]!, 12),
    );
  }
});
