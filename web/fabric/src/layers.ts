/**
 * Layers of a draft: interlacements that lie upon one another and that no thread binds together.
 *
 * Lifting a thread lifts every thread above it. A drawdown falls apart where some ends and picks can be lifted off all
 * others; since every end of a repeat crosses every pick, one repeat does so as endless cloth does.
 */
import type { Structure } from "./draft.ts";
import type { Warn } from "./errors.ts";

/**
 * Ends and picks of each layer of a drawdown, from the top; threads that never interlace are in none.
 *
 * Let t ends and s of m picks be lifted off. Those ends pass over all m − s other picks, and those picks are below no
 * other end, so that Σ (picks below those ends) − Σ (ends above those picks) = t·(m − s), which no other choice
 * exceeds. Hence the ends that pass over most picks and the picks below fewest ends tell.
 *
 * Source: C. R. J. Clapham, When a fabric hangs together, Bull. London Math. Soc. 12 (1980).
 */
export function layerSizes({ ends, picks, drawdown }: Structure): [number, number][] {
  const belowEnd = new Int32Array(ends);
  const abovePick = new Int32Array(picks);
  for (let pick = 0, at = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++, at++) {
      belowEnd[end]! += drawdown[at]!;
      abovePick[pick]! += drawdown[at]!;
    }
  belowEnd.sort().reverse();
  abovePick.sort();
  const sizes: [number, number][] = [];
  let [least, most, ofEnds, ofPicks] = [0, 0, 0, 0];
  let last = { picks: 0, ends: 0 };
  for (let lifted = 0; lifted <= picks; lifted++) {
    const others = picks - lifted;
    // Ends that pass over more than the other picks, and over as many: the latter lie upon them, or are loose.
    for (; least < ends && belowEnd[least]! > others; least++) ofEnds += belowEnd[least]!;
    for (most = Math.max(most, least); most < ends && belowEnd[most]! >= others; ) most++;
    if (lifted > 0) ofPicks += abovePick[lifted - 1]!;
    if (ofEnds - ofPicks !== least * others) continue;
    if (lifted > 0 && least > last.ends) sizes.push([least - last.ends, lifted - last.picks]);
    last = { picks: lifted, ends: most };
  }
  return sizes;
}

/** Warns in a sentence, which begins with the file, of a drawdown that holds layers. */
export function warnOfLayers(structure: Structure, file: string, warn: Warn): void {
  const sizes = layerSizes(structure);
  const [upper, under] = sizes;
  if (upper === undefined || under === undefined) return;
  warn(
    `${file} holds ${sizes.length} layers of cloth that no thread binds together (${upper[0]} ends and ${upper[1]} ` +
      `picks lie above ${under[0]} ends and ${under[1]} picks); neural ` +
      `and clustered do not take it, and pages without Python show a single plane.`,
  );
}
