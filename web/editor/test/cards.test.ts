import { describe, expect, it } from "vitest";

import { addCard, cards, cardsOf, colourNamed, nameOfColour, removeCard } from "../src/keeping/cards.ts";
import { ODD, randomOf } from "./odd.ts";

const file = (name: string, text: string): File => new File([text], name);

describe("colour cards", () => {
  it("are added, used by name, replaced by their name, and removed; here the browser keeps nothing and the page says so", async () => {
    expect(await addCard(file("house.csv", "Navy 12,#30497a"))).toEqual([expect.stringMatching(/the browser keeps no more/)]);
    await addCard(file("mill.gpl", "GIMP Palette\nName: Mill\n1 2 3 Tar"));
    expect(cards().map(({ name }) => name)).toEqual(["Mill", "house"]);
    expect(colourNamed(" NAVY 12 ")?.hex).toBe("#30497a");
    expect(nameOfColour("#010203")).toBe("Tar (Mill)");
    await addCard(file("house.csv", "Navy 12,#000080"));
    expect(cards().map(({ name }) => name)).toEqual(["house", "Mill"]);
    expect(colourNamed("navy 12")?.hex).toBe("#000080");
    removeCard("house");
    expect(colourNamed("navy 12")).toBeNull();
    await expect(addCard(file("wrong.ase", "JASC"))).rejects.toThrow(/^wrong.ase: it is no Adobe Swatch Exchange file/);
    expect(cards().map(({ name }) => name)).toEqual(["Mill"]);
  });

  it("that were kept are read, whatever became of them", () => {
    const kept = [{ name: "House", colours: [{ name: "Navy", hex: "#30497a" }, { name: "Red", hex: "#7d2b33" }] }];
    expect(cardsOf(JSON.stringify(kept))).toEqual(kept);
    const random = randomOf(7);
    for (let turn = 0; turn < 300; turn++) {
      const value = ODD.filter((each) => typeof each !== "bigint")[Math.floor(random() * (ODD.length - 1))];
      const places: (() => unknown)[] = [() => value, () => [value, kept[0]], () => [{ ...kept[0], name: value }], () => [{ ...kept[0], colours: value }], () => [{ name: "House", colours: [value, { name: value, hex: "#30497a" }, { name: "Navy", hex: value }] }]];
      for (const { name, colours } of cardsOf(JSON.stringify(places[Math.floor(random() * places.length)]!()) ?? null)) {
        expect(typeof name).toBe("string");
        expect(colours.length).toBeGreaterThan(0);
        for (const colour of colours) expect(colour.hex).toMatch(/^#[0-9a-f]{6}$/);
      }
    }
  });
});
