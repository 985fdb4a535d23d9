/** Looms: the drawdown of a threading, a tie-up and a treadling, and a plan that weaves a given drawdown. */
import { InputError } from "./errors.ts";
import type { LoomPlan, Sets, Structure } from "./draft.ts";

/**
 * Which shafts each pick moves, by the treadles if there are any.
 *
 * @throws InputError a plan with neither a liftplan nor tie-up and treadling.
 */
export function movedShafts(plan: LoomPlan): Sets {
  const { tieup, treadling, liftplan } = plan;
  if (tieup !== null && treadling !== null) {
    const byTreadles = new Map<string, readonly number[]>();
    return treadling.map((pressed) => {
      const key = pressed.join();
      let moved = byTreadles.get(key);
      if (moved === undefined) {
        moved = ascending(pressed.flatMap((treadle) => tieup[treadle - 1] ?? []));
        byTreadles.set(key, moved);
      }
      return moved;
    });
  }
  if (liftplan === null)
    throw new InputError("The loom plan has neither a liftplan nor a tie-up with a treadling.");
  return liftplan;
}

/**
 * What the plan weaves.
 *
 * An end is up on a rising shed if any of its shafts is lifted, and on a sinking shed unless any of its shafts
 * is lowered; an end on no shaft stays down on the former and up on the latter.
 */
export function planDrawdown(plan: LoomPlan): Structure {
  const moved = movedShafts(plan);
  const ends = plan.threading.length;
  const drawdown = new Uint8Array(moved.length * ends);
  // Ends that are threaded alike are computed once.
  const kinds: (readonly number[])[] = [];
  const kindOf = new Map<string, number>();
  const kindOfEnd = Int32Array.from(plan.threading, (shafts) => {
    const key = shafts.join();
    let kind = kindOf.get(key);
    if (kind === undefined) {
      kind = kinds.length;
      kindOf.set(key, kind);
      kinds.push(shafts);
    }
    return kind;
  });
  const isMoved = new Uint8Array(plan.shafts + 1);
  const kindUp = new Uint8Array(kinds.length);
  moved.forEach((shafts, pick) => {
    isMoved.fill(0);
    for (const shaft of shafts) if (shaft <= plan.shafts) isMoved[shaft] = 1;
    kinds.forEach((members, kind) => {
      const any = members.some((shaft) => isMoved[shaft] === 1);
      kindUp[kind] = any === plan.risingShed ? 1 : 0;
    });
    for (let end = 0; end < ends; end++) drawdown[pick * ends + end] = kindUp[kindOfEnd[end]!]!;
  });
  return { ends, picks: moved.length, drawdown };
}

/** Shafts named by a liftplan or a tie-up at most: beyond, a file of a draft grows past what is read again. */
const MAX_LIFTS = 12_000_000;
/** With more kinds of picks than both shafts and this, a treadling only repeats the liftplan at length. */
const TREADLES_AT_HAND = 16;

/**
 * A plan for a rising shed that weaves the structure: equal ends share a shaft, equal picks a treadle.
 *
 * Shafts and treadles are numbered as they first occur. Where far more kinds of picks than shafts are needed
 * the plan is a liftplan.
 *
 * @throws InputError more lifts than a file of a draft holds.
 */
export function deriveLoomPlan(structure: Structure): LoomPlan {
  const { ends, picks, drawdown } = structure;
  const columns = kindsOf(ends, (end) => {
    const column = new Uint8Array(picks);
    for (let pick = 0; pick < picks; pick++) column[pick] = drawdown[pick * ends + end]!;
    return column;
  });
  const rows = kindsOf(picks, (pick) => drawdown.subarray(pick * ends, (pick + 1) * ends));
  const shafts = columns.first.length;
  const lifts = rows.first.map((pick) =>
    columns.first.flatMap((end, shaft) => (drawdown[pick * ends + end] === 1 ? [shaft + 1] : [])),
  );
  const isLiftplan = lifts.length > Math.max(shafts, TREADLES_AT_HAND);
  const count = isLiftplan
    ? rows.kind.reduce((sum, kind) => sum + lifts[kind]!.length, 0)
    : lifts.reduce((sum, members) => sum + members.length, 0);
  if (count > MAX_LIFTS)
    throw new InputError(
      `The draft needs ${shafts} shafts and a plan of ${Math.round(count / 1e6)} million lifts; a weaving information ` +
        `file that is read again has ${MAX_LIFTS / 1e6} million: keep it as a picture.`,
    );
  const threading = columns.kind.map((kind) => [kind + 1]);
  if (isLiftplan) {
    const liftplan = rows.kind.map((kind) => lifts[kind]!);
    return { threading, shafts, treadles: 0, tieup: null, treadling: null, liftplan, risingShed: true };
  }
  const treadling = rows.kind.map((kind) => [kind + 1]);
  return { threading, shafts, treadles: lifts.length, tieup: lifts, treadling, liftplan: null, risingShed: true };
}

/** For each line the number of its kind; for each kind its first line. */
function kindsOf(count: number, line: (index: number) => Uint8Array): { kind: number[]; first: number[] } {
  const seen = new Map<string, number>();
  const first: number[] = [];
  const kind = Array.from({ length: count }, (_, index) => {
    const key = packed(line(index));
    let number = seen.get(key);
    if (number === undefined) {
      number = first.length;
      seen.set(key, number);
      first.push(index);
    }
    return number;
  });
  return { kind, first };
}

/** Bits as a string of one UTF-16 unit for each 15 of them. */
function packed(bits: Uint8Array): string {
  let text = "";
  for (let at = 0; at < bits.length; at += 15) {
    let unit = 1;
    for (let offset = 0; offset < 15; offset++) unit = (unit << 1) | (bits[at + offset] ?? 0);
    text += String.fromCharCode(unit & 0xffff);
  }
  return text;
}

/** The numbers without repetition, in ascending order. */
export function ascending(numbers: Iterable<number>): number[] {
  return [...new Set(numbers)].sort((a, b) => a - b);
}

/** Whether a plan weaves exactly the structure. */
export function weaves(plan: LoomPlan, structure: Structure): boolean {
  const woven = planDrawdown(plan);
  return (
    woven.ends === structure.ends &&
    woven.picks === structure.picks &&
    woven.drawdown.every((up, at) => up === structure.drawdown[at])
  );
}

/** The same plan with a lift of shafts for each pick, in place of tie-up and treadling. */
export function asLiftplan(plan: LoomPlan): LoomPlan {
  return { ...plan, treadles: 0, tieup: null, treadling: null, liftplan: movedShafts(plan) };
}

/** The same plan with a treadle for each kind of pick, numbered as they first occur, in place of a liftplan. */
export function asTreadling(plan: LoomPlan): LoomPlan {
  if (plan.treadling !== null) return { ...plan, liftplan: null };
  const tieup: (readonly number[])[] = [];
  const treadleOf = new Map<string, number>();
  const treadling = movedShafts(plan).map((shafts) => {
    const key = shafts.join();
    let treadle = treadleOf.get(key);
    if (treadle === undefined) {
      tieup.push(shafts);
      treadle = tieup.length;
      treadleOf.set(key, treadle);
    }
    return [treadle];
  });
  return { ...plan, treadles: tieup.length, tieup, treadling, liftplan: null };
}
