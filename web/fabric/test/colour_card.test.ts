import { describe, expect, it } from "vitest";

import { isInputError, labToLinear, MAX_CARD, parseColour, readColourCard, toHex, type ReadCard } from "../src/index.ts";

const text = (...lines: string[]): Uint8Array => new TextEncoder().encode(lines.join("\n"));
const read = (file: string, ...lines: string[]): ReadCard => readColourCard(text(...lines), file);

/** A swatch file as Adobe's programs write it: a group, its colours, the end of the group. */
function ase(group: string, ...colours: (readonly [string, string, ...number[]])[]): Uint8Array {
  const named = (name: string): number[] => [(name.length + 1) >> 8, (name.length + 1) & 255, ...[...name, "\0"].flatMap((sign) => [sign.charCodeAt(0) >> 8, sign.charCodeAt(0) & 255])];
  const float = (value: number): number[] => {
    const view = new DataView(new ArrayBuffer(4));
    view.setFloat32(0, value);
    return [...new Uint8Array(view.buffer)];
  };
  const block = (kind: number, content: number[]): number[] => [kind >> 8, kind & 255, 0, 0, content.length >> 8, content.length & 255, ...content];
  const entries = colours.map(([name, model, ...values]) => block(1, [...named(name), ...[...model].map((sign) => sign.charCodeAt(0)), ...values.flatMap(float), 0, 2]));
  const blocks = [block(0xc001, named(group)), ...entries, block(0xc002, [])];
  return Uint8Array.from([...[..."ASEF"].map((sign) => sign.charCodeAt(0)), 0, 1, 0, 0, 0, 0, 0, blocks.length, ...blocks.flat()]);
}

describe("Lab", () => {
  it.each([
    // L*, a*, b* of sRGB's corners relative to D50, as ICC programs show them, to two digits.
    ["#ff0000", 54.29, 80.81, 69.89],
    ["#00ff00", 87.82, -79.29, 80.99],
    ["#0000ff", 29.57, 68.3, -112.03],
    ["#ffffff", 100, 0, 0],
  ] as const)("of %s comes back from D50", (hex, lightness, a, b) => {
    expect(toHex(labToLinear([lightness, a, b], "D50"))).toBe(hex);
  });

  it("relative to D65 is that of fabric files", () => {
    expect(toHex(labToLinear([31, 6, -32], "D65"))).toBe(toHex(parseColour("lab(31 6 -32)", "colour")));
    expect(toHex(labToLinear([31, 6, -32], "D50"))).not.toBe(toHex(labToLinear([31, 6, -32], "D65")));
  });
});

describe("a swatch file", () => {
  it("has a name of its own, RGB, grey and Lab", () => {
    const { card, warnings } = readColourCard(ase("House 2026", ["Türkis", "RGB ", 0, 0.5, 1], ["Ash", "Gray", 0.5], ["Signal", "LAB ", 0.5429, 80.81, 69.89]), "house.ase");
    expect(card).toEqual({
      name: "House 2026",
      colours: [
        { name: "Türkis", hex: "#0080ff" },
        { name: "Ash", hex: "#808080" },
        { name: "Signal", hex: "#ff0000" },
      ],
    });
    expect(warnings).toEqual([]);
  });

  it("leaves inks out and says so, and that a colour is outside sRGB", () => {
    const { card, warnings } = readColourCard(ase("", ["Ink", "CMYK", 1, 0, 0, 0], ["Neon", "LAB ", 0.8, 100, 90]), "press.ase");
    expect(card.name).toBe("press");
    expect(card.colours).toHaveLength(1);
    expect(warnings).toEqual([expect.stringMatching(/^press.ase: 1 colours are amounts of ink/), expect.stringMatching(/1 colours lie outside sRGB/)]);
    expect(() => readColourCard(ase("", ["Ink", "CMYK", 1, 0, 0, 0]), "press.ase")).toThrow(/^press.ase: its colours are amounts of ink/);
  });

  it("that is cut off, or damaged anywhere, ends in a sentence that names it", () => {
    const whole = ase("House", ["Blue", "RGB ", 0, 0, 1], ["Sky", "LAB ", 0.7, -10, -30]);
    let refused = 0;
    for (let length = 0; length < whole.length; length++)
      expect(() => readColourCard(whole.subarray(0, length), "cut.ase")).toThrow(/^cut.ase: .*\.?$/);
    for (let at = 0; at < whole.length; at++)
      for (const value of [0, 1, 127, 255]) {
        const damaged = whole.slice();
        damaged[at] = value;
        try {
          for (const { hex } of readColourCard(damaged, "damaged.ase").card.colours) expect(hex).toMatch(/^#[0-9a-f]{6}$/);
        } catch (error) {
          refused++;
          expect(isInputError(error)).toBe(true);
          expect((error as Error).message).toMatch(/^damaged.ase: /);
        }
      }
    expect(refused).toBeGreaterThan(50);
  });
});

describe("a GIMP palette", () => {
  it("has rows of red, green and blue", () => {
    expect(read("tartan.gpl", "GIMP Palette", "Name: Tartan", "Columns: 4", "#", "  0   0 128 Navy blue", "255 255 255\tWhite", "1 2 3").card).toEqual({
      name: "Tartan",
      colours: [
        { name: "Navy blue", hex: "#000080" },
        { name: "White", hex: "#ffffff" },
        { name: "#010203", hex: "#010203" },
      ],
    });
  });

  it.each([
    [["JASC-PAL"], /^x.gpl: it is no GIMP palette/],
    [["GIMP Palette", "0 0 300 Blue"], /^x.gpl: line 2, "0 0 300 Blue", is no colour: write red/],
    [["GIMP Palette", "#", "blue"], /^x.gpl: line 3, "blue"/],
    [["GIMP Palette"], /^x.gpl: it has no colours/],
  ])("of %j is refused", (lines, sentence) => {
    expect(() => read("x.gpl", ...lines)).toThrow(sentence);
  });
});

describe("a table", () => {
  const colours = (...lines: string[]) => read("book.csv", ...lines).card.colours.map(({ name, hex }) => `${name} ${hex}`);

  it("has names and hex, with titles or without, in any order", () => {
    expect(colours("name,hex", "Navy,#30497a", '"Red, dark",7d2b33')).toEqual(["Navy #30497a", "Red, dark #7d2b33"]);
    expect(colours("#30497a;Navy", "#7d2b33;Red")).toEqual(["Navy #30497a", "Red #7d2b33"]);
    expect(colours("Code\tHex\tRemark", 'A "1"\t#fff\tnew')).toEqual(['A "1" #ffffff']);
  });

  it("has Lab relative to D65, or to D50 where that is said", () => {
    const blue = "Blue;29,57;68,30;-112,03";
    expect(colours("Name;L*;a*;b*", "# relative to D50", blue)).toEqual(["Blue #0000ff"]);
    expect(colours("Name;L_D50;a_D50;b_D50", blue)).toEqual(["Blue #0000ff"]);
    expect(colours("Navy,31,6,-32")).toEqual([`Navy ${toHex(parseColour("lab(31 6 -32)", "colour"))}`]);
  });

  it.each([
    [["name,hex", "Navy,blue"], 'book.csv: line 2: "blue" is no colour: write hex such as #20305c.'],
    [["name,hex", "", "Navy,"], 'book.csv: line 3: "Navy, " has no colour: write hex such as #20305c, or L, a and b.'],
    [["name,L,a,b", "Navy,31,6,x"], 'book.csv: line 2: "Navy, 31, 6, x" has no numbers L, a and b.'],
    [["name,L,a,b", "Navy,131,6,2"], "book.csv: line 2: L = 131, a = 6, b = 2 is no colour; L is 0 to 100, a and b are -150 to 150."],
    [["400,0.1", "410,0.2"], 'book.csv: line 1: "400, 0.1" has no colour: write hex such as #20305c, or L, a and b.'],
    [['"Navy,#30497a'], "book.csv: line 1 has a quotation mark that is not closed."],
    [[""], "book.csv: it is empty: write a name and a colour in each row."],
  ])("of %j is refused", (lines, sentence) => {
    expect(() => read("book.csv", ...lines)).toThrow(sentence);
  });

  it("has so many colours at most", () => {
    expect(() => read("book.csv", ...Array.from({ length: MAX_CARD + 1 }, () => "a,#123456"))).toThrow(/more than 5000 colours/);
  });
});
