/** Drafts as JSON, as the server writes and reads them (`src/loomlight/viewer/messages.py`). */
import { makeDraft, type Draft, type LoomPlan, type Threads } from "./draft.ts";
import { InputError } from "./errors.ts";
import { requireDraftJson } from "./json_check.ts";
import { MAX_NAME, type DraftJson, type LoomJson, type ThreadsJson } from "./messages.ts";

/** The draft as JSON. */
export function draftToJson(draft: Draft): DraftJson {
  return {
    name: draft.name.slice(0, MAX_NAME),
    ends: draft.ends,
    picks: draft.picks,
    drawdown: bitsToText(draft.drawdown),
    warp: threadsToJson(draft.warp),
    weft: threadsToJson(draft.weft),
    loom: draft.loom === null ? null : loomToJson(draft.loom),
  };
}

/**
 * The draft of its JSON. Without palette rows, colours become a palette in the order of their occurrence.
 *
 * @throws InputError values that are none of a draft, or that do not belong together.
 */
export function draftFromJson(given: unknown): Draft {
  const json = requireDraftJson(given);
  const { ends, picks } = json;
  const drawdown = textToBits(json.drawdown, ends * picks);
  const rows = new Map<string, number>();
  const palette: number[] = [];
  const isIndexed = [json.warp, json.weft].every(({ colors, color_index }) => colors === null || color_index);
  const family = (threads: ThreadsJson): Threads => {
    const colorIndex =
      threads.colors === null
        ? null
        : Int32Array.from(threads.colors, (colour, thread) => {
            const key = colour.join();
            const row = isIndexed ? threads.color_index![thread]! : (rows.get(key) ?? rows.size);
            rows.set(key, row);
            while (palette.length < 3 * row) palette.push(0);
            palette.splice(3 * row, 3, ...colour);
            return row;
          });
    return {
      colors: threads.colors === null ? null : Float64Array.from(threads.colors.flat()),
      spacingMm: threads.spacing_mm === null ? null : Float64Array.from(threads.spacing_mm),
      thicknessMm: threads.thickness_mm === null ? null : Float64Array.from(threads.thickness_mm),
      colorIndex,
    };
  };
  const warp = family(json.warp);
  const weft = family(json.weft);
  return makeDraft(
    { ends, picks, drawdown },
    {
      name: json.name,
      warp,
      weft,
      loom: json.loom === null ? null : loomFromJson(json.loom),
      palette: palette.length > 0 ? Float64Array.from(palette) : null,
    },
  );
}

function threadsToJson(threads: Threads): ThreadsJson {
  const { colors } = threads;
  return {
    colors:
      colors === null
        ? null
        : Array.from({ length: colors.length / 3 }, (_, thread) => [
            colors[thread * 3]!,
            colors[thread * 3 + 1]!,
            colors[thread * 3 + 2]!,
          ]),
    spacing_mm: threads.spacingMm === null ? null : [...threads.spacingMm],
    thickness_mm: threads.thicknessMm === null ? null : [...threads.thicknessMm],
    color_index: threads.colorIndex === null ? null : [...threads.colorIndex],
  };
}

function loomToJson(loom: LoomPlan): LoomJson {
  const copy = (sets: LoomPlan["tieup"]): number[][] | null => sets?.map((members) => [...members]) ?? null;
  return {
    shafts: loom.shafts,
    treadles: loom.treadles,
    rising_shed: loom.risingShed,
    threading: copy(loom.threading) ?? [],
    tieup: copy(loom.tieup),
    treadling: copy(loom.treadling),
    liftplan: copy(loom.liftplan),
  };
}

function loomFromJson(json: LoomJson): LoomPlan {
  const { shafts, treadles, rising_shed: risingShed, threading, tieup, treadling, liftplan } = json;
  return { shafts, treadles, risingShed, threading, tieup, treadling, liftplan };
}

/** Base64 of bits, eight a byte, the first highest. */
export function bitsToText(bits: Uint8Array): string {
  let binary = "";
  for (let at = 0; at < bits.length; at += 8) {
    let byte = 0;
    for (let offset = 0; offset < 8; offset++) byte = (byte << 1) | (bits[at + offset] ?? 0);
    binary += String.fromCharCode(byte);
  }
  return btoa(binary);
}

/**
 * `count` bits of their base64.
 *
 * @throws InputError too few bits, or no base64.
 */
export function textToBits(text: string, count: number): Uint8Array {
  let binary: string;
  try {
    binary = atob(text);
  } catch {
    throw new InputError("the drawdown of the draft is no base64.");
  }
  if (binary.length !== Math.ceil(count / 8))
    throw new InputError(`the drawdown of the draft has ${binary.length * 8} crossings where ${count} are needed.`);
  return Uint8Array.from({ length: count }, (_, at) => (binary.charCodeAt(at >> 3) >> (7 - (at & 7))) & 1);
}
