import { loadDraft } from "loomlight-fabric";
import { expect, test } from "vitest";

import type { Fabric } from "../src/state/document.ts";
import { isServed, ServedModels } from "../src/view/served_models.ts";

const fabric = (roughness: number): Fabric => {
  const fields = { weave: "plain", warp: { roughness } };
  return { fields, draft: loadDraft(fields) };
};
/** Lets what was answered arrive. */
const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

test("tables are asked for one at a time, and then for the latest edit", async () => {
  const asked: Fabric[] = [];
  const answers: ((content: Uint8Array) => void)[] = [];
  let arrivals = 0;
  const source = (_: string, one: Fabric): Promise<Uint8Array> => {
    asked.push(one);
    return new Promise((resolve) => answers.push(resolve));
  };
  const served = new ServedModels(source, () => arrivals++, () => {});
  const [first, second, third] = [fabric(0.1), fabric(0.2), fabric(0.3)];
  for (const one of [first, first, second, third]) expect(served.tables("neural", one)).toBe(null);
  expect(asked).toEqual([first]);
  answers[0]!(Uint8Array.of(1));
  await settle();
  // Older tables are shown until the latest are here.
  expect(served.tables("neural", third)).toEqual(Uint8Array.of(1));
  expect(asked).toEqual([first, third]);
  answers[1]!(Uint8Array.of(2));
  await settle();
  expect(served.tables("neural", third)).toEqual(Uint8Array.of(2));
  expect([asked.length, arrivals]).toEqual([2, 2]);
  // Of another cloth none are: the page shows it by itself.
  const other = { fields: { weave: "satin 8/3" }, draft: loadDraft({ weave: "satin 8/3" }) };
  expect(served.tables("neural", other)).toBe(null);
  expect(served.tables("neural", third)).toEqual(Uint8Array.of(2));
});

test("a refusal is told once, and the next edit is asked for again", async () => {
  let isGone = true;
  const told: string[] = [];
  const source = async (): Promise<Uint8Array> => {
    if (isGone) throw new Error("The server does not answer.");
    return Uint8Array.of(3);
  };
  const served = new ServedModels(source, () => {}, (sentence) => told.push(sentence));
  for (const roughness of [0.1, 0.2]) {
    expect(served.tables("neural", fabric(roughness))).toBe(null);
    await settle();
  }
  expect(told).toEqual(["The server does not answer."]);
  isGone = false;
  const last = fabric(0.3);
  served.tables("neural", last);
  await settle();
  expect(served.tables("neural", last)).toEqual(Uint8Array.of(3));
});

test("the page bakes lobes itself", () => {
  expect([isServed("neural"), isServed("clustered"), isServed("lobes")]).toEqual([true, true, false]);
});
