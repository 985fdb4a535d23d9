/**
 * Bends of yarns that a fabric file need not say: they depend on the weave. `generated.ts` has the other defaults.
 *
 * Inclination and twist are those commonly suggested for the three basic weaves (Jin et al. 2022); to a draft that has
 * no name they apply by its structure.
 */
import { isUp, type Structure } from "./draft.ts";


/** Which basic weave a drawdown resembles most. */
export type BasicWeave = "plain" | "twill" | "satin";

/** How one family lies: inclination of a float's ends and twist of the fibres, degrees. */
export interface Bend {
  readonly inclinationDeg: number;
  readonly twistDeg: number;
}

const bend = (inclinationDeg: number, twistDeg: number): Bend => ({ inclinationDeg, twistDeg });
const BENDS: Readonly<Record<BasicWeave, readonly [Bend, Bend]>> = {
  plain: [bend(22, 0), bend(16, 0)],
  twill: [bend(24, -30), bend(24, -30)],
  satin: [bend(60, 0), bend(35, 0)],
};

/**
 * The basic weave of a drawdown.
 *
 * Plain: each end crosses like its neighbour or exactly the other way (tabby, basket, rib). Satin: most points that
 * stand alone among their four neighbours stand alone among all eight. Twill: all else.
 */
export function basicWeave(structure: Structure): BasicWeave {
  const { ends, picks } = structure;
  if (isPlain(structure)) return "plain";
  const differs = (pick: number, end: number, rise: number, run: number): boolean =>
    isUp(structure, pick, end) !== isUp(structure, (pick - rise + picks) % picks, (end - run + ends) % ends);
  let ofFour = 0;
  let ofEight = 0;
  for (let pick = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++) {
      if (!FOUR.every(([rise, run]) => differs(pick, end, rise, run))) continue;
      ofFour++;
      if (DIAGONAL.every(([rise, run]) => differs(pick, end, rise, run))) ofEight++;
    }
  return ofFour * 50 >= ends * picks && 2 * ofEight >= ofFour ? "satin" : "twill";
}

const FOUR = [
  [0, 1],
  [0, -1],
  [1, 0],
  [-1, 0],
] as const;
const DIAGONAL = [
  [1, 1],
  [1, -1],
  [-1, 1],
  [-1, -1],
] as const;

function isPlain(structure: Structure): boolean {
  const { ends, picks } = structure;
  for (let end = 0; end < ends; end++) {
    const beside = (end + ends - 1) % ends;
    let alike = 0;
    for (let pick = 0; pick < picks; pick++) if (isUp(structure, pick, end) === isUp(structure, pick, beside)) alike++;
    if (alike !== 0 && alike !== picks) return false;
  }
  return true;
}

/** Default bends of warp and weft; in a weft-faced satin the weft takes the warp's. */
export function bendsOf(structure: Structure): { warp: Bend; weft: Bend } {
  const weave = basicWeave(structure);
  const [warp, weft] = BENDS[weave];
  const up = structure.drawdown.reduce((sum, crossing) => sum + crossing, 0);
  const isWeftFaced = up * 2 < structure.drawdown.length;
  return weave === "satin" && isWeftFaced ? { warp: weft, weft: warp } : { warp, weft };
}
