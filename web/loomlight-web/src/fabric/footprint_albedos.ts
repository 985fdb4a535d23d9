/** Tables from which shaders read mean albedos over footprints; see `aggregate/footprint_albedos.py`. */
import { rint } from "loomlight-fabric";

import { ALBEDO_AREA_UNITS, ALBEDO_MIN_QUANTITIES, ALBEDO_MAX_ENTRIES } from "../generated.ts";
import { ALBEDO_NUMBERS } from "./albedos.ts";
import { principalAxes } from "./principal_axes.ts";
import { pairwiseSum } from "./sums.ts";
import type { FamilyTables } from "./threads.ts";

/** One family's colours: quantities are 1 and the principal coordinates of its threads' albedos. */
export interface ColourTables {
  readonly mean: Float64Array;
  readonly axes: Float64Array;
  /** 1 + principal coordinates; 1 where all threads are alike. */
  readonly quantities: number;
  /** Of each thread its quantities, then their integrals over visible widths and cells before it [n + 1, 3, q]. */
  readonly threads: Float64Array;
  /** Integrals over all crossings before, of threads on top, in units [crossings + 1, n + 1, q]. */
  readonly areas: Uint32Array;
  /** Square millimetres of a unit, and of a crossing on average. */
  readonly unit: number;
  readonly crossing: number;
}

/** Tables of a family; `onTop` is [crossings, threads]. */
export function colourTables(
  albedos: Float64Array,
  own: FamilyTables,
  other: FamilyTables,
  onTop: Uint8Array,
): ColourTables {
  const count = own.lower.length;
  const crossings = other.lower.length;
  const entries = (count + 1) * (crossings + 1);
  const most = Math.max(Math.floor(ALBEDO_MAX_ENTRIES / entries), ALBEDO_MIN_QUANTITIES) - 1;
  const { mean, axes, coordinates, count: rank } = principalAxes(albedos, ALBEDO_NUMBERS, most);
  const nothing = { mean, axes, quantities: 1, threads: new Float64Array(0), areas: new Uint32Array(0) };
  if (rank === 0) return { ...nothing, unit: 1, crossing: 1 };
  const quantities = rank + 1;
  const visible = own.halfWidth.map((half) => 2 * half);
  const lengths = other.halfWidth.map((half) => 2 * half);
  const quantity = (thread: number, number: number): number =>
    number === 0 ? 1 : coordinates[thread * rank + number - 1]!;
  const threads = new Float64Array((count + 1) * 3 * quantities);
  for (let number = 0; number < quantities; number++) {
    let overWidths = 0;
    let overCells = 0;
    for (let thread = 0; thread < count; thread++) {
      const value = quantity(thread, number);
      overWidths += value * visible[thread]!;
      overCells += value * (own.upper[thread]! - own.lower[thread]!);
      threads[thread * 3 * quantities + number] = value;
      threads[((thread + 1) * 3 + 1) * quantities + number] = overWidths;
      threads[((thread + 1) * 3 + 2) * quantities + number] = overCells;
    }
  }
  const area = pairwiseSum(visible) * pairwiseSum(lengths);
  const unit = area / ALBEDO_AREA_UNITS;
  const areas = new Uint32Array(entries * quantities);
  const column = new Float64Array(count);
  for (let number = 0; number < quantities; number++) {
    column.fill(0);
    for (let crossing = 0; crossing < crossings; crossing++) {
      let sum = 0;
      for (let thread = 0; thread < count; thread++) {
        if (onTop[crossing * count + thread]!)
          column[thread]! += lengths[crossing]! * quantity(thread, number) * visible[thread]!;
        sum += column[thread]!;
        areas[((crossing + 1) * (count + 1) + thread + 1) * quantities + number] = rint(sum / unit);
      }
    }
  }
  return { mean, axes, quantities, threads, areas, unit, crossing: area / (count * crossings) };
}
