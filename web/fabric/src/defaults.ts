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
  if (isPlain(structure)) return "plain";
  const { ends, picks, drawdown } = structure;
  let ofFour = 0;
  let ofEight = 0;
  for (let pick = 0; pick < picks; pick++) {
    const row = pick * ends;
    const below = ((pick + picks - 1) % picks) * ends;
    const above = ((pick + 1) % picks) * ends;
    for (let end = 0; end < ends; end++) {
      const face = drawdown[row + end];
      const left = end === 0 ? ends - 1 : end - 1;
      const right = end === ends - 1 ? 0 : end + 1;
      if (drawdown[row + left] === face || drawdown[row + right] === face) continue;
      if (drawdown[below + end] === face || drawdown[above + end] === face) continue;
      ofFour++;
      if (drawdown[below + left] === face || drawdown[below + right] === face) continue;
      if (drawdown[above + left] !== face && drawdown[above + right] !== face) ofEight++;
    }
  }
  return ofFour * 50 >= ends * picks && 2 * ofEight >= ofFour ? "satin" : "twill";
}

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

interface Bends {
  readonly warp: Bend;
  readonly weft: Bend;
}

/** Of drawdowns, which stay while colours and numbers change. */
const bendsOfDrawdown = new WeakMap<Uint8Array, Bends>();

/** Default bends of warp and weft; in a weft-faced satin the weft takes the warp's. */
export function bendsOf(structure: Structure): Bends {
  const bends = bendsOfDrawdown.get(structure.drawdown) ?? foundBends(structure);
  bendsOfDrawdown.set(structure.drawdown, bends);
  return bends;
}

function foundBends(structure: Structure): Bends {
  const weave = basicWeave(structure);
  const [warp, weft] = BENDS[weave];
  const up = structure.drawdown.reduce((sum, crossing) => sum + crossing, 0);
  const isWeftFaced = up * 2 < structure.drawdown.length;
  return weave === "satin" && isWeftFaced ? { warp: weft, weft: warp } : { warp, weft };
}
