/** What JSON of a draft must be before a draft is made of it; the rules are those of `viewer/messages.py`. */
import { MAXIMUM_THREADS } from "./draft.ts";
import { InputError } from "./errors.ts";
import { LENGTH_MM, MAX_NAME, type DraftJson, type LoomJson, type ThreadsJson } from "./messages.ts";

/**
 * JSON as that of a draft.
 *
 * @throws InputError values of another type or range, or lists that do not fit the drawdown.
 */
export function requireDraftJson(json: unknown): DraftJson {
  const draft = tableOf(json, "draft") as unknown as DraftJson;
  require(typeof draft.name === "string" && draft.name.length <= MAX_NAME, `draft.name is no text of at most ${MAX_NAME} characters`);
  for (const name of ["ends", "picks"] as const)
    require(isWhole(draft[name], 1, MAXIMUM_THREADS), `draft.${name} is no whole number from 1 to ${MAXIMUM_THREADS}`);
  require(typeof draft.drawdown === "string", "draft.drawdown is no base64");
  requireThreads(draft.warp, draft.ends, "draft.warp");
  requireThreads(draft.weft, draft.picks, "draft.weft");
  if (draft.loom !== null) requireLoom(draft.loom, draft.ends, draft.picks);
  return draft;
}

function requireThreads(json: unknown, count: number, place: string): void {
  const threads = tableOf(json, place) as unknown as ThreadsJson;
  const { colors, spacing_mm, thickness_mm, color_index = null } = threads;
  const isColour = (colour: unknown): boolean =>
    Array.isArray(colour) && colour.length === 3 && colour.every((part) => isNumber(part, 0, 1));
  const isLength = (length: unknown): boolean => isNumber(length, ...LENGTH_MM);
  requireList(colors, count, isColour, `${place}.colors must list linear RGB in [0, 1]`);
  requireList(spacing_mm, count, isLength, `${place}.spacing_mm must list millimetres`);
  requireList(thickness_mm, count, isLength, `${place}.thickness_mm must list millimetres`);
  requireList(color_index, count, (row) => isWhole(row, 0, MAXIMUM_THREADS), `${place}.color_index must list rows`);
}

function requireLoom(json: unknown, ends: number, picks: number): void {
  const loom = tableOf(json, "draft.loom") as unknown as LoomJson;
  const { shafts, treadles, threading, tieup, treadling, liftplan } = loom;
  for (const name of ["shafts", "treadles"] as const)
    require(isWhole(loom[name], 0, MAXIMUM_THREADS), `draft.loom.${name} is no whole number up to ${MAXIMUM_THREADS}`);
  require(typeof loom.rising_shed === "boolean", "draft.loom.rising_shed is neither true nor false");
  require(threading !== null, "draft.loom.threading is missing");
  require(liftplan !== null || (tieup !== null && treadling !== null), "draft.loom has neither a liftplan nor a tie-up with a treadling");
  const requireSets = (sets: unknown, count: number, most: number, name: string): void =>
    requireList(sets, count, (set) => isSet(set, most), `draft.loom.${name} must list sets of numbers from 1 to ${most}`);
  requireSets(threading, ends, shafts, "threading");
  requireSets(tieup, treadles, shafts, "tieup");
  requireSets(treadling, picks, treadles, "treadling");
  requireSets(liftplan, picks, shafts, "liftplan");
}

function requireList(list: unknown, count: number, isRight: (item: unknown) => boolean, sentence: string): void {
  if (list === null) return;
  require(Array.isArray(list) && list.length === count && list.every(isRight), `${sentence}, one for each of ${count}`);
}

function isSet(set: unknown, most: number): boolean {
  return Array.isArray(set) && set.every((member) => isWhole(member, 1, most));
}

function isWhole(value: unknown, low: number, high: number): boolean {
  return Number.isInteger(value) && isNumber(value, low, high);
}

function isNumber(value: unknown, low: number, high: number): boolean {
  return typeof value === "number" && low <= value && value <= high;
}

function tableOf(value: unknown, place: string): Readonly<Record<string, unknown>> {
  require(typeof value === "object" && value !== null && !Array.isArray(value), `${place} is missing`);
  return value as Readonly<Record<string, unknown>>;
}

function require(isRight: boolean, sentence: string): void {
  if (!isRight) throw new InputError(`${sentence}.`);
}
