/** What was set aside is opened again, as far as it can be. */
import { expect, it } from "vitest";

import { fabricOfAside } from "../src/aside_file.ts";
import { documentText } from "../src/keeping/document_text.ts";
import { linkOf } from "../src/link.ts";
import { firstState } from "../src/state/document.ts";
import { fabricFromJson, fabricText } from "../src/state/fabric_json.ts";

const FIELDS = { weave: "twill 3/1", ends_per_cm: 20, warp: { roughness: 0.3, color: "#30497a" }, weft: { roughness: 0.4 } };
const aside = (text: string, reason = "a panel fails"): string => JSON.stringify({ reason, text });
const damaged = (fields: unknown): string => aside(JSON.stringify({ fabric: { fields } }));

it("whole, of a document, of a fabric and of a link", async () => {
  const fabric = fabricFromJson({ fields: FIELDS });
  const link = `#${(await linkOf(fabric))!}`;
  for (const text of [documentText(firstState(fabric)), fabricText(fabric), link]) {
    const opened = await fabricOfAside(aside(text));
    expect([fabricText(opened.fabric), opened.faults]).toEqual([fabricText(fabric), []]);
  }
});

it("without the fields that cannot be, each told", async () => {
  const { fabric, faults } = await fabricOfAside(damaged({ ...FIELDS, gap: 7, warp: { ...FIELDS.warp, count: "thin" }, weft: 3 }));
  expect(fabric.fields).toEqual({ weave: "twill 3/1", ends_per_cm: 20, warp: FIELDS.warp });
  expect(faults.join()).toMatch(/gap/);
  expect(faults.join()).toMatch(/warp\.count/);
  expect(faults.join()).toMatch(/weft/);
});

it("of fields that exclude each other with the first", async () => {
  const { fabric, faults } = await fabricOfAside(damaged({ epi: 50, weave: "plain", ends_per_cm: 20 }));
  expect(fabric.fields).toEqual({ weave: "plain", epi: 50 });
  expect(faults).toHaveLength(1);
});

it("nothing at all: the sentence says why", async () => {
  await expect(fabricOfAside("{")).rejects.toThrow("no file that this page has set aside");
  await expect(fabricOfAside("[1]")).rejects.toThrow("no file that this page has set aside");
  await expect(fabricOfAside(aside('{"fabric": {"fie', "it is damaged"))).rejects.toThrow("damaged");
  await expect(fabricOfAside(aside("#f=AAAA"))).rejects.toThrow("damaged");
  await expect(fabricOfAside(damaged({ weave: "no such weave" }))).rejects.toThrow("no such weave");
});
