/**
 * Reads weaving information files (WIF 1.1, and variants that programs write) into drafts.
 *
 * What the specification leaves open is decided here:
 *
 * - A draft has as many ends as [THREADING] lists, whatever [WARP] Threads declares beyond that: such threads are
 *   placeholders of an unfinished draft. Picks likewise.
 * - Where [LIFTPLAN] stands beside [TIEUP] and [TREADLING], the treadling is woven; if they differ, a warning says
 *   so, and both are kept.
 * - What no thread needs may be wrong and is passed over with a warning: a default or a unit that nothing uses,
 *   colours that no thread has, the plan that is not woven.
 *
 * Source: Weaving Information File specification 1.1, 20 April 1997.
 */
import { makeDraft, MAXIMUM_THREADS, type Draft, type Entries, type LoomPlan, type Sets } from "./draft.ts";
import { InputError, type Warn } from "./errors.ts";
import { warnOfLayers } from "./layers.ts";
import { movedShafts, planDrawdown } from "./loom.ts";
import { defaultsCountFromZero, readFamily, readPalette, warnOfThickThreads } from "./wif_threads.ts";
import { decodeWif, MAXIMUM_BYTES, parseWifText, shortened, type WifText } from "./wif_text.ts";
import { integer, numberSet, threadNumber, withoutComment, yesOrNo } from "./wif_values.ts";

/**
 * The draft in the bytes of a weaving information file; a draft without a title takes the file's stem.
 *
 * @param file what messages call the file.
 * @param warn receives a sentence for each value that is passed over.
 * @throws InputError the file cannot be used; the message names section, key and value.
 */
export function readWif(bytes: Uint8Array, file = "draft.wif", warn: Warn = () => undefined): Draft {
  if (bytes.length > MAXIMUM_BYTES)
    throw new InputError(`${file} is larger than ${MAXIMUM_BYTES >> 20} MiB; no draft that can be used is.`);
  const draft = draftOfText(parseWifText(decodeWif(bytes), file, warn));
  const stem = file.replace(/^.*[\\/]/, "").replace(/(?!^)\.[^.]*$/, "");
  return draft.name.trim() === "" ? { ...draft, name: stem } : draft;
}

/** Keys that are interpreted, by section; null for every key of the section. */
const INTERPRETED: ReadonlyMap<string, ReadonlySet<string> | null> = new Map([
  ...["CONTENTS", "NOTES", "THREADING", "TIEUP", "TREADLING", "LIFTPLAN", "COLOR TABLE"].map(
    (name): [string, null] => [name, null],
  ),
  ["COLOR PALETTE", new Set(["RANGE", "ENTRIES"])],
  ["WIF", new Set<string>()],
  ["TEXT", new Set(["TITLE"])],
  ["WEAVING", new Set(["SHAFTS", "TREADLES", "RISING SHED"])],
  ...["WARP", "WEFT"].map((family): [string, ReadonlySet<string>] => [
    family,
    new Set(["THREADS", "COLOR", "UNITS", "SPACING", "THICKNESS"]),
  ]),
  ...["WARP", "WEFT"].flatMap((family) =>
    ["COLORS", "SPACING", "THICKNESS"].map((what): [string, null] => [`${family} ${what}`, null]),
  ),
]);

function draftOfText(text: WifText): Draft {
  const warpThreads = declaredThreads(text, "WARP");
  const weftThreads = declaredThreads(text, "WEFT");
  const loom = readLoom(text, warpThreads, weftThreads);
  const { palette, range } = readPalette(text);
  const picks = (loom.treadling ?? loom.liftplan ?? []).length;
  const firstDefault = defaultsCountFromZero(text, palette) ? 0 : 1;
  const warp = readFamily(text, "WARP", loom.threading.length, palette, firstDefault);
  const weft = readFamily(text, "WEFT", picks, palette, firstDefault);
  warnOfThickThreads(text, warp.threads, weft.threads);
  const structure = planDrawdown(loom);
  warnOfLayers(structure, text.file, text.report);
  return makeDraft(structure, {
    name: text.value("TEXT", "Title"),
    warp: warp.threads,
    weft: weft.threads,
    loom,
    palette,
    notes: notesOf(text),
    source: {
      warp: { ...warp.defaults, threads: warpThreads },
      weft: { ...weft.defaults, threads: weftThreads },
      colorRange: range,
      entries: otherEntries(text),
      sections: otherSections(text),
    },
  });
}

function declaredThreads(text: WifText, family: string): number | null {
  const value = text.value(family, "Threads");
  if (withoutComment(value) === "") return null;
  return integer(text, family, "Threads", value, 1, MAXIMUM_THREADS, "a number of threads");
}

type Table = ReadonlyMap<number, readonly number[]>;

/** Sets by number; nothing, with a warning, of a faulty section that is `unused` for the reason given. */
function readSets(text: WifText, section: string, of: string, what: string, unused = ""): Table {
  const sets = new Map<number, readonly number[]>();
  try {
    for (const [key, value] of text.items(section)) {
      const number = threadNumber(text, section, key, value, `the number of ${of}`);
      sets.set(number, numberSet(text, section, key, value, what));
    }
  } catch (fault) {
    if (unused === "" || !(fault instanceof InputError)) throw fault;
    text.report(`${fault.message.slice(0, -1)}; it is passed over, since ${unused}.`);
    return new Map();
  }
  return sets;
}

const anySet = (table: Table): boolean => [...table.values()].some((members) => members.length > 0);
const highest = (numbers: Iterable<number>): number => {
  let most = 0;
  for (const number of numbers) most = Math.max(most, number);
  return most;
};
const highestMember = (table: Table): number => highest([...table.values()].map((members) => members.at(-1) ?? 0));
const highestUsed = (table: Table): number =>
  highest([...table].flatMap(([number, members]) => (members.length > 0 ? [number] : [])));

function readLoom(text: WifText, warpThreads: number | null, weftThreads: number | null): LoomPlan {
  if (!text.has("THREADING"))
    throw new InputError(
      `${text.file}: the section [THREADING] is missing; it says which shaft carries each end.`,
    );
  const threading = readSets(text, "THREADING", "an end", "shafts");
  const treadling = readSets(text, "TREADLING", "a pick", "treadles");
  const hasTreadling = anySet(treadling);
  const tieup = readSets(text, "TIEUP", "a treadle", "shafts", hasTreadling ? "" : "no pick presses a treadle");
  const treadled = anySet(tieup) && hasTreadling;
  const liftplan = readSets(text, "LIFTPLAN", "a pick", "shafts", treadled ? "the treadling is woven" : "");
  if (!anySet(threading))
    throw new InputError(`${text.file}: [THREADING] puts no end on a shaft; each line is an end=its shaft.`);
  if (!treadled && !anySet(liftplan)) throw nothingLifts(text, tieup, treadling);
  const nothing: Table = new Map();
  const pressed = treadled ? treadling : nothing;
  const shafts = shaftCount(text, [threading, tieup, liftplan]);
  const treadles = treadleCount(text, tieup, pressed);
  const ends = threadCount(text, "WARP", "THREADING", threading, warpThreads);
  // Both plans, if there are two, cover the same picks.
  const picks = highest(
    (
      [
        ["TREADLING", pressed],
        ["LIFTPLAN", liftplan],
      ] as const
    ).flatMap(([section, sets]) => (sets.size > 0 ? [threadCount(text, "WEFT", section, sets, weftThreads)] : [])),
  );
  const plan: LoomPlan = {
    threading: sequence(threading, ends),
    shafts,
    treadles,
    tieup: treadled ? sequence(tieup, treadles) : null,
    treadling: treadled ? sequence(treadling, picks) : null,
    liftplan: anySet(liftplan) ? sequence(liftplan, picks) : null,
    risingShed: yesOrNo(text, "WEAVING", "Rising Shed", true),
  };
  if (plan.treadling === null || plan.liftplan === null) return plan;
  comparePlans(text, plan, plan.treadling);
  return completed(text, plan, plan.treadling, plan.liftplan);
}

function sequence(sets: Table, count: number): Sets {
  return Array.from({ length: count }, (_, index) => sets.get(index + 1) ?? []);
}

function nothingLifts(text: WifText, tieup: Table, treadling: Table): InputError {
  for (const [section, sets, needed, purpose] of [
    ["TREADLING", treadling, "TIEUP", "which shafts each treadle moves"],
    ["TIEUP", tieup, "TREADLING", "which treadles each pick presses"],
  ] as const) {
    const used = [...sets].find(([, members]) => members.length > 0)?.[0];
    if (used === undefined) continue;
    const state = text.has(needed) ? "is empty" : "is missing";
    return text.fault(
      section,
      String(used),
      text.value(section, String(used)),
      `needs the section [${needed}], which ${state}: it says ${purpose}; a [LIFTPLAN] would do as well`,
    );
  }
  const said = text.value("CONTENTS", "LIFTPLAN");
  const contents = said === "" ? "" : ` ([CONTENTS] says LIFTPLAN=${shortened(said)})`;
  return new InputError(
    `${text.file}: [LIFTPLAN] is ${text.has("LIFTPLAN") ? "empty" : "missing"}${contents}, and so are [TIEUP] and ` +
      "[TREADLING]: one or the other must say which shafts each pick lifts.",
  );
}

function shaftCount(text: WifText, tables: readonly Table[]): number {
  const value = text.value("WEAVING", "Shafts");
  const used = highest(tables.map(highestMember));
  if (withoutComment(value) === "") return used;
  const declared = integer(text, "WEAVING", "Shafts", value, 0, MAXIMUM_THREADS, "a number of shafts");
  if (0 < declared && declared < used)
    text.warn("WEAVING", "Shafts", value, `is too low: the draft uses shaft ${used}, and so many are taken`);
  return Math.max(declared, used);
}

function treadleCount(text: WifText, tieup: Table, treadling: Table): number {
  const value = text.value("WEAVING", "Treadles");
  const declared =
    withoutComment(value) === ""
      ? 0
      : integer(text, "WEAVING", "Treadles", value, 0, MAXIMUM_THREADS, "a number of treadles");
  const treadles = Math.max(declared, highestUsed(tieup));
  for (const [pick, pressed] of treadling) {
    const most = pressed.at(-1) ?? 0;
    if (most > treadles)
      throw text.fault(
        "TREADLING",
        String(pick),
        text.value("TREADLING", String(pick)),
        `presses treadle ${most}, and [TIEUP] and [WEAVING] know ${treadles}; tie that treadle up or press another`,
      );
  }
  return treadles;
}

function threadCount(text: WifText, family: string, section: string, sets: Table, declared: number | null): number {
  if (declared === null) return highest(sets.keys());
  const used = highestUsed(sets);
  if (declared < used)
    text.warn(
      family,
      "Threads",
      text.value(family, "Threads"),
      `is too low: [${section}] goes up to ${used}, and so many are taken`,
    );
  return Math.max(used, highest([...sets.keys()].filter((number) => number <= declared)));
}

function comparePlans(text: WifText, plan: LoomPlan, treadling: Sets): void {
  const byTreadles = planDrawdown(plan).drawdown;
  const byLiftplan = planDrawdown({ ...plan, tieup: null, treadling: null }).drawdown;
  const pickOf = (at: number) => Math.floor(at / plan.threading.length);
  const different = byTreadles.findIndex((up, at) => up !== byLiftplan[at] && treadling[pickOf(at)]!.length > 0);
  if (different < 0) return;
  const pick = String(pickOf(different) + 1);
  text.warn(
    "LIFTPLAN",
    pick,
    text.value("LIFTPLAN", pick),
    `differs from [TREADLING] ${pick}=${text.value("TREADLING", pick)} with [TIEUP]; the treadling is woven`,
  );
}

/** A plan whose treadling leaves picks to its liftplan, as one liftplan; any other as it is. */
function completed(text: WifText, plan: LoomPlan, treadling: Sets, liftplan: Sets): LoomPlan {
  const left = liftplan.flatMap((lifted, pick) => (lifted.length > 0 && treadling[pick]!.length === 0 ? [pick] : []));
  if (left.length === 0) return plan;
  const pick = String(left[0]! + 1);
  text.warn(
    "LIFTPLAN",
    pick,
    text.value("LIFTPLAN", pick),
    `is woven, as [TREADLING] presses nothing there; ${left.length} such picks are the liftplan's`,
  );
  const lifts = movedShafts(plan).map((moved, at) => (treadling[at]!.length === 0 ? liftplan[at]! : moved));
  return { ...plan, treadles: 0, tieup: null, treadling: null, liftplan: lifts };
}

function notesOf(text: WifText): string[] {
  return (text.sections.get("NOTES")?.lines ?? []).map(([key, value]) =>
    value === null ? key : /^[0-9]+$/.test(key) ? value : `${key}=${value}`,
  );
}

/** What known sections hold besides what is interpreted. */
function otherEntries(text: WifText): [string, Entries][] {
  const kept: [string, Entries][] = [];
  for (const [name, keys] of INTERPRETED) {
    if (keys === null) continue;
    const lines = (text.sections.get(name)?.lines ?? []).filter(([key]) => !keys.has(key.toUpperCase()));
    if (lines.length > 0) kept.push([name, lines]);
  }
  return kept;
}

function otherSections(text: WifText): [string, Entries][] {
  return [...text.sections]
    .filter(([name]) => !INTERPRETED.has(name))
    .map(([, section]) => [section.spelled, section.lines]);
}
