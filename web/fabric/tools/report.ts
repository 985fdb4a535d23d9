/** What this package makes of weaves and files, as JSON that a test compares with the Python package. */
import {
  artworkFromJson,
  artworkOfPixels,
  artworkToJson,
  bendsOf,
  bitsToText,
  clothFacts,
  colouredDraft,
  draftOfPixels,
  familySpacing,
  familyWidth,
  irregularityOf,
  isInputError,
  loadDraft,
  planDrawdown,
  readToml,
  readWif,
  weaveArtwork,
  writeToml,
  writeWif,
  type Draft,
  type FabricFields,
  type FamilyName,
} from "../src/index.ts";

export type Question =
  | { kind: "weave"; text: string }
  | { kind: "wif"; name: string; base64: string }
  | { kind: "toml"; text: string }
  | { kind: "picture"; name: string; rgba: string; width: number; height: number }
  | { kind: "artwork"; name: string; toml: string; rgba: string; width: number; height: number };

/** The answer to a question, `{ error }` for input that is refused. */
export function report(question: Question): object {
  const warnings: string[] = [];
  try {
    switch (question.kind) {
      case "weave":
        return fabric({ weave: question.text }, loadDraft({ weave: question.text }));
      case "wif": {
        const draft = readWif(Buffer.from(question.base64, "base64"), question.name, (text) => warnings.push(text));
        const again = readWif(new TextEncoder().encode(writeWif(draft)), question.name);
        return {
          ...fabric({ draft: question.name }, draft),
          warnings,
          isLoomTrue: draft.loom !== null && same(planDrawdown(draft.loom).drawdown, draft.drawdown),
          isKeptByWriting: JSON.stringify(described(again)) === JSON.stringify(described(draft)),
          written: writeWif(draft),
        };
      }
      case "picture": {
        const { name, rgba, width, height } = question;
        const draft = draftOfPixels(new Uint8ClampedArray(Buffer.from(rgba, "base64")), width, height, name);
        return fabric({ image: name }, draft);
      }
      case "artwork": {
        const { name, rgba, width, height } = question;
        const fields = readToml(question.toml);
        const read = artworkOfPixels(new Uint8ClampedArray(Buffer.from(rgba, "base64")), width, height, name, fields);
        const json = artworkToJson(read);
        const { draft, longestFloat, cut } = weaveArtwork(artworkFromJson(json), fields, name);
        return { ...fabric(fields, draft), longestFloat, cut, json };
      }
      case "toml": {
        const fields = readToml(question.text);
        return { ...fabric(fields, loadDraft(fields)), written: writeToml(fields) };
      }
    }
  } catch (error) {
    if (!isInputError(error)) throw error;
    return { error: error.message };
  }
}

function same(a: Uint8Array, b: Uint8Array): boolean {
  return a.length === b.length && a.every((value, at) => value === b[at]);
}

function fabric(fields: FabricFields, named: Draft): object {
  const draft = colouredDraft(named, fields);
  const { warp, weft } = bendsOf(draft);
  const widths = (family: FamilyName): number[] => {
    const spacing = familySpacing(fields, family, draft);
    return [...spacing, ...familyWidth(fields, family, draft, spacing)];
  };
  return {
    ...described(draft),
    bends: [warp, weft],
    weight: clothFacts(fields, draft).weight,
    lengths: { warp: widths("warp"), weft: widths("weft") },
    irregularity: { warp: irregularityOf(fields, "warp"), weft: irregularityOf(fields, "weft") },
  };
}

function described(draft: Draft): object {
  return {
    name: draft.name,
    ends: draft.ends,
    picks: draft.picks,
    drawdown: bitsToText(draft.drawdown),
    warp: [...(draft.warp.colors ?? [])],
    weft: [...(draft.weft.colors ?? [])],
    notes: draft.notes,
  };
}
