/** What a search in the gallery finds: every word is somewhere in what a fabric or a weave says of itself. */
import { FAMILIES } from "loomlight-fabric";

import { nameOf, type Fabric } from "../state/document.ts";

/** Whether a text has every word of a search; capitals, accents and what stands between words do not matter. */
export function isFound(sought: string, ...texts: readonly string[]): boolean {
  const text = plain(texts.join(" "));
  return plain(sought)
    .split(" ")
    .every((word) => text.includes(word));
}

/** What a fabric says of itself: name, description, weave, kinds and counts of yarn. */
export function saidOf(fabric: Fabric): string {
  const { fields } = fabric;
  const yarns = FAMILIES.flatMap((family) => [fields[family]?.yarn, fields[family]?.count]);
  return [nameOf(fabric), fields.description, fields.weave, fabric.draft.name, fields.yarn, ...yarns].filter(Boolean).join(" ");
}

const plain = (text: string): string =>
  text
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/[\s,;:]+/g, " ")
    .trim();
