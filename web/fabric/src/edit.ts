/** Edits of a draft, each a new draft: crossings, loom plans, and how many threads, shafts and treadles there are. */
import { makeDraft, MAXIMUM_THREADS, structureOf, type Draft, type LoomPlan, type Sets, type Structure, type Threads } from "./draft.ts";
import { InputError } from "./errors.ts";
import { ascending, asLiftplan, asTreadling, deriveLoomPlan, planDrawdown, weaves } from "./loom.ts";
import { clamp } from "./numbers.ts";
import { pickRows } from "./palette.ts";

/** Plans that weave a drawdown, and what they weave: of thousands of threads a comparison takes a quarter of a second. */
const wovenBy = new WeakMap<LoomPlan, Uint8Array>();
/** Plans derived of drawdowns, which stay while colours and numbers change. */
const derivedOf = new WeakMap<Uint8Array, LoomPlan>();

/** The plan of a draft: its own if it weaves the drawdown, else a derived one. */
export function loomOf({ loom, ...draft }: Draft): LoomPlan {
  if (loom === null || (wovenBy.get(loom) !== draft.drawdown && !weaves(loom, draft))) return derivedPlan(draft);
  wovenBy.set(loom, draft.drawdown);
  return loom;
}

/** A plan that weaves a drawdown; see `deriveLoomPlan`. */
export function derivedPlan(structure: Structure): LoomPlan {
  const plan = derivedOf.get(structure.drawdown) ?? deriveLoomPlan(structure);
  derivedOf.set(structure.drawdown, plan);
  wovenBy.set(plan, structure.drawdown);
  return plan;
}

/** The draft with the other thread on top at one crossing, 0-based; its plan is derived anew. */
export function withCrossing(draft: Draft, pick: number, end: number, isWarpUp: boolean): Draft {
  const drawdown = draft.drawdown.slice();
  drawdown[pick * draft.ends + end] = isWarpUp ? 1 : 0;
  const edited = makeDraft({ ends: draft.ends, picks: draft.picks, drawdown }, draft);
  return { ...edited, loom: derivedPlan(edited) };
}

/** The draft that a plan for as many ends and picks weaves. */
export function withLoom(draft: Draft, loom: LoomPlan): Draft {
  const structure = planDrawdown(loom);
  wovenBy.set(loom, structure.drawdown);
  return { ...makeDraft(structure, draft), loom };
}

/** One member put into, or taken out of, one set; the sets are 0-based, members 1-based. */
export function withMember(sets: Sets, index: number, member: number, isIn: boolean): Sets {
  return sets.map((members, at) => {
    if (at !== index) return members;
    const others = members.filter((number) => number !== member);
    return isIn ? ascending([...others, member]) : others;
  });
}

/** One set replaced by a single member. */
export function withOnly(sets: Sets, index: number, member: number): Sets {
  return sets.map((members, at) => (at === index ? [member] : members));
}

/** The draft whose plan has a lift for each pick, or a treadling. */
export function withPlanKind(draft: Draft, kind: "liftplan" | "treadling"): Draft {
  const loom = loomOf(draft);
  return { ...draft, loom: kind === "liftplan" ? asLiftplan(loom) : asTreadling(loom) };
}

/** The draft with as many shafts and treadles as asked, but never fewer than its plan uses. */
export function withShafts(draft: Draft, shafts: number, treadles: number): Draft {
  const loom = loomOf(draft);
  const most = (sets: Sets | null): number => (sets ?? []).reduce((high, set) => Math.max(high, set.at(-1) ?? 0), 0);
  const least = Math.max(most(loom.threading), most(loom.tieup), most(loom.liftplan), 1);
  const count = clamp(shafts, least, MAXIMUM_THREADS);
  if (loom.tieup === null) return { ...draft, loom: { ...loom, shafts: count } };
  const treadleCount = clamp(treadles, Math.max(most(loom.treadling), 1), MAXIMUM_THREADS);
  const tieup = Array.from({ length: treadleCount }, (_, treadle) => loom.tieup![treadle] ?? []);
  return { ...draft, loom: { ...loom, shafts: count, tieup, treadles: treadleCount } };
}

/**
 * The draft with as many ends and picks; new ones go on as the draft began, as a repeat does.
 *
 * @throws InputError fewer than two, or more than 16384.
 */
export function withSize(draft: Draft, ends: number, picks: number): Draft {
  if (![ends, picks].every((count) => Number.isInteger(count) && count >= 2 && count <= MAXIMUM_THREADS))
    throw new InputError(`A draft of ${ends} ends and ${picks} picks cannot be: it has 2 to ${MAXIMUM_THREADS} of each.`);
  const structure = structureOf(
    picks,
    ends,
    (pick, end) => draft.drawdown[(pick % draft.picks) * draft.ends + (end % draft.ends)] === 1,
  );
  const loom = loomOf(draft);
  const repeated = (sets: Sets | null, count: number): Sets | null =>
    sets === null ? null : Array.from({ length: count }, (_, index) => sets[index % sets.length]!);
  return makeDraft(structure, {
    ...draft,
    warp: resized(draft.warp, draft.ends, ends),
    weft: resized(draft.weft, draft.picks, picks),
    loom: {
      ...loom,
      threading: repeated(loom.threading, ends)!,
      treadling: repeated(loom.treadling, picks),
      liftplan: repeated(loom.liftplan, picks),
    },
    source: null,
  });
}

/** The cloth turned over sideways: the other thread is on top everywhere, seen from behind. */
export function turnedOver(draft: Draft): Draft {
  const { ends, picks, drawdown } = draft;
  const structure = structureOf(picks, ends, (pick, end) => drawdown[pick * ends + (ends - 1 - end)] === 0);
  const turned = { ...makeDraft(structure, draft), warp: reordered(draft.warp, ends), loom: null };
  return { ...turned, loom: derivedPlan(turned) };
}

function reordered(threads: Threads, count: number): Threads {
  return gathered(threads, Int32Array.from({ length: count }, (_, thread) => count - 1 - thread));
}

function resized(threads: Threads, before: number, after: number): Threads {
  return gathered(threads, Int32Array.from({ length: after }, (_, thread) => thread % before));
}

/** The threads whose numbers are listed, 0-based. */
function gathered(threads: Threads, index: Int32Array): Threads {
  const take = (values: Float64Array | null): Float64Array | null =>
    values === null ? null : Float64Array.from(index, (thread) => values[thread]!);
  return {
    colors: threads.colors === null ? null : pickRows(threads.colors, index),
    spacingMm: take(threads.spacingMm),
    thicknessMm: take(threads.thicknessMm),
    colorIndex: threads.colorIndex === null ? null : index.map((thread) => threads.colorIndex![thread]!),
  };
}
