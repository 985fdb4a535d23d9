/** A file of what was set aside, opened again: what of it can be is a fabric, and the rest is told. */
import { FAMILIES, InputError, messageOf } from "loomlight-fabric";

import { jsonOfLink } from "./link.ts";
import type { Fabric } from "./state/document.ts";
import { fabricFromJson } from "./state/fabric_json.ts";
import { isTable, tableOf, type Table } from "./state/json_table.ts";

/**
 * The fabric of a file that the page made of what it set aside, without the fields that cannot be, and what was wrong.
 *
 * @throws InputError another file, or one of which nothing is left; the message says what is wrong.
 */
export async function fabricOfAside(text: string): Promise<{ fabric: Fabric; faults: readonly string[] }> {
  const { fields, ...drawn } = await fabricIn(text);
  try {
    return { fabric: fabricFromJson({ fields, ...drawn }), faults: [] };
  } catch (error) {
    return repaired(fields, drawn, error);
  }
}

/** What a fabric's JSON has beside its fields. */
interface Drawn {
  readonly draft: unknown;
  readonly artwork: unknown;
}

/** The JSON of the fabric: of a document, of a fabric alone, or of a link. */
async function fabricIn(text: string): Promise<Drawn & { fields: Table }> {
  const file = parsed(text, "it is no file that this page has set aside");
  if (typeof file["text"] !== "string") throw new InputError("it is no file that this page has set aside.");
  const content = file["text"];
  const damaged = `what was set aside is damaged (${String(file["reason"] ?? "it cannot be read")})`;
  const json = content.startsWith("#") ? await jsonOfLink(content).catch(() => null) : parsed(content, damaged);
  const fabric = tableOf(tableOf(json)["fields"] === undefined ? tableOf(json)["fabric"] : json);
  if (Object.keys(fabric).length === 0) throw new InputError(`${damaged}.`);
  return { fields: tableOf(fabric["fields"]), draft: fabric["draft"], artwork: fabric["artwork"] };
}

function parsed(text: string, fault: string): Table {
  try {
    return tableOf(JSON.parse(text));
  } catch {
    throw new InputError(`${fault}.`);
  }
}

/** The fabric of the draft alone, and then of every further field that it takes. */
function repaired(fields: Table, drawn: Drawn, why: unknown): { fabric: Fabric; faults: readonly string[] } {
  const named = Object.entries(fields).filter(([key]) => ["weave", "draft", "image", "weaves"].includes(key));
  let kept: Table = Object.fromEntries(named);
  let fabric: Fabric;
  try {
    fabric = fabricFromJson({ fields: kept, ...drawn });
  } catch {
    throw why; // the draft itself
  }
  const others = Object.entries(fields).flatMap(([key, value]): [string, string | null, unknown][] =>
    FAMILIES.some((family) => family === key) && isTable(value)
      ? Object.entries(value).map(([inner, each]) => [key, inner, each])
      : key in kept
        ? []
        : [[key, null, value]],
  );
  const faults: string[] = [];
  for (const [key, inner, value] of others) {
    const more = { ...kept, [key]: inner === null ? value : { ...tableOf(kept[key]), [inner]: value } };
    try {
      fabric = fabricFromJson({ fields: more, ...drawn });
      kept = more;
    } catch (error) {
      faults.push(messageOf(error));
    }
  }
  return { fabric, faults };
}
