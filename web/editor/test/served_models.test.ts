import { expect, test } from "vitest";

import type { Fabric } from "../src/state/document.ts";
import { ServedModels } from "../src/view/served_models.ts";

const fabric = (): Fabric => ({ fields: {}, draft: {} }) as unknown as Fabric;
const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

test("asks one at a time, for the newest fabric, and shows older tables meanwhile", async () => {
  const asked: Fabric[] = [];
  const answers: ((content: Uint8Array) => void)[] = [];
  let arrivals = 0;
  const served = new ServedModels(
    (_, about) => {
      asked.push(about);
      return new Promise((resolve) => answers.push(resolve));
    },
    () => arrivals++,
    () => undefined,
  );
  const [first, second, third] = [fabric(), fabric(), fabric()];
  expect(served.tables("woven", first)).toBeNull();
  expect(served.tables("woven", second)).toBeNull();
  expect(served.tables("woven", third)).toBeNull();
  answers[0]!(Uint8Array.of(1));
  await settled();
  expect(served.tables("woven", third)).toEqual(Uint8Array.of(1));
  expect(asked).toEqual([first, third]);
  answers[1]!(Uint8Array.of(3));
  await settled();
  expect(served.tables("woven", third)).toEqual(Uint8Array.of(3));
  expect([asked.length, arrivals]).toEqual([2, 2]);
});

test("says a fault once, not at each edit", async () => {
  const said: string[] = [];
  const refuse = (): Promise<Uint8Array> => Promise.reject(new Error("There is no Python here."));
  const served = new ServedModels(refuse, () => undefined, (sentence) => said.push(sentence));
  for (const edit of [fabric(), fabric()]) {
    expect(served.tables("clustered", edit)).toBeNull();
    await settled();
  }
  expect(said).toEqual(["There is no Python here."]);
});
