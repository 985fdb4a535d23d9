/**
 * How yarns vary over millimetres to metres, as integrals that shaders read: the twin of `scattering/irregularity.py`,
 * which says what they are.
 */
import { clamp, rint, type Irregularity } from "loomlight-fabric";

import {
  IRREGULAR_BLOCK as BLOCK,
  IRREGULAR_CUT_LENGTH,
  IRREGULAR_DRAFTING_LENGTH,
  IRREGULAR_DRAFTING_SHARE,
  IRREGULAR_DRAFTING_SPREAD,
  IRREGULAR_DRIFT_LENGTH,
  IRREGULAR_DRIFT_SHARE,
  IRREGULAR_LARGEST_INTEGRAL,
  IRREGULAR_LARGEST_TONE,
  IRREGULAR_LEAST_THICKNESS,
  IRREGULAR_LOT_LENGTH,
  IRREGULAR_LOT_STREAM,
  IRREGULAR_MELANGE_LENGTH,
  IRREGULAR_MELANGE_STREAM,
  IRREGULAR_NEP_STREAM,
  IRREGULAR_QUANTITIES as QUANTITIES,
  IRREGULAR_RANDOM_SHARE,
  IRREGULAR_RELIEF,
  IRREGULAR_ROWS as ROWS,
  IRREGULAR_SAMPLES as SAMPLES,
  IRREGULAR_SHADE_STREAM,
  IRREGULAR_STEP as STEP,
  IRREGULAR_THICK_STREAM,
  IRREGULAR_THICKNESS_STREAM,
} from "../generated.ts";
import { ALBEDO_NUMBERS } from "./albedos.ts";
import { pairwiseSum } from "./sums.ts";
import type { FamilyTables } from "./threads.ts";

/** The process of one family as integrals. */
export interface IrregularTable {
  /** Over threads and steps before [ROWS + BLOCK + 1, SAMPLES, QUANTITIES], signed integers. */
  readonly integrals: Uint32Array;
  /** What the integer 1 stands for: thickness, cover, tone and nep times a thread and a step. */
  readonly units: readonly [number, number, number, number];
}

const WAVES = SAMPLES / 2;

/** The last few results of a function, by its arguments: sliders go to and fro. */
function remembered<A extends readonly number[], R>(make: (...given: A) => R, limit = 4): (...given: A) => R {
  const known = new Map<string, R>();
  return (...given) => {
    const key = given.join();
    const found = known.get(key) ?? make(...given);
    known.delete(key);
    known.set(key, found);
    if (known.size > limit) known.delete(known.keys().next().value!);
    return found;
  };
}

// ------------------------------------------------------------------------------------------------- random numbers

function scrambled(value: number): number {
  const state = (Math.imul(value, 747796405) + 2891336453) >>> 0;
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0;
  return ((word >>> 22) ^ word) >>> 0;
}

/** Numbers in (0, 1) of each row [ROWS, count], which depend on the stream, row and column alone. */
function randomNumbers(stream: number, count: number): Float64Array {
  const found = new Float64Array(ROWS * count);
  for (let row = 0; row < ROWS; row++) {
    const key = scrambled(row + scrambled(stream));
    for (let column = 0; column < count; column++)
      found[row * count + column] = (scrambled(column + key) + 0.5) * 2 ** -32;
  }
  return found;
}

// ---------------------------------------------------------------------------------------------------- the process

/** Waves of a table per millimetre. */
const FREQUENCIES = Float64Array.from({ length: WAVES }, (_, wave) => (wave + 1) / (SAMPLES * STEP));

function sinc(x: number): number {
  return x === 0 ? 1 : Math.sin(Math.PI * x) / (Math.PI * x);
}

/** Variance of the mass by wave, without thick places. */
function massSpectrum(massCv: number, fibreLength: number): Float64Array {
  const total = new Float64Array(WAVES);
  const add = (share: number, spectrum: (f: number) => number): void => {
    const part = FREQUENCIES.map(spectrum);
    // Drafting waves of filaments are longer than the table.
    const scale = Math.max(pairwiseSum(part), 1e-12);
    part.forEach((value, wave) => (total[wave]! += (share * value) / scale));
  };
  add(IRREGULAR_RANDOM_SHARE, (f) => sinc(f * fibreLength) ** 2);
  add(
    IRREGULAR_DRAFTING_SHARE,
    (f) => Math.exp(-0.5 * (Math.log(f * IRREGULAR_DRAFTING_LENGTH * fibreLength) / IRREGULAR_DRAFTING_SPREAD) ** 2) / f,
  );
  add(IRREGULAR_DRIFT_SHARE, (f) => 1 / (f * (1 + (f * IRREGULAR_DRIFT_LENGTH * fibreLength) ** 2)));
  const ofCuts = pairwiseSum(total.map((value, wave) => value * sinc(FREQUENCIES[wave]! * IRREGULAR_CUT_LENGTH) ** 2));
  return total.map((value) => value * (massCv ** 2 / ofCuts));
}

/** A process [ROWS, SAMPLES] of a variance by wave, waves with phases by chance. */
function waves(spectrum: Float64Array, stream: number): Float64Array {
  const found = new Float64Array(ROWS * SAMPLES);
  if (spectrum.every((value) => value === 0)) return found;
  const numbers = randomNumbers(stream, WAVES);
  const sizes = spectrum.map((value) => 0.5 * Math.sqrt(2 * value));
  const last = Math.sqrt(spectrum[WAVES - 1]!);
  const real = new Float64Array(SAMPLES);
  const imaginary = new Float64Array(SAMPLES);
  // Two rows by one transform, as its real and its imaginary part.
  for (let row = 0; row < ROWS; row += 2) {
    real[0] = imaginary[0] = 0;
    for (let wave = 1; wave < WAVES; wave++) {
      const [one, two] = [0, 1].map((more) => 2 * Math.PI * numbers[(row + more) * WAVES + wave - 1]!) as [number, number];
      const size = sizes[wave - 1]!;
      const [a, b, c, d] = [size * Math.cos(one), size * Math.sin(one), size * Math.cos(two), size * Math.sin(two)];
      real[wave] = a - d;
      imaginary[wave] = b + c;
      real[SAMPLES - wave] = a + d;
      imaginary[SAMPLES - wave] = c - b;
    }
    real[WAVES] = last * Math.cos(2 * Math.PI * numbers[row * WAVES + WAVES - 1]!);
    imaginary[WAVES] = last * Math.cos(2 * Math.PI * numbers[(row + 1) * WAVES + WAVES - 1]!);
    transform(real, imaginary);
    found.set(real, row * SAMPLES);
    found.set(imaginary, (row + 1) * SAMPLES);
  }
  return found;
}

const COSINES = Float64Array.from({ length: WAVES }, (_, turn) => Math.cos((2 * Math.PI * turn) / SAMPLES));
const SINES = Float64Array.from({ length: WAVES }, (_, turn) => Math.sin((2 * Math.PI * turn) / SAMPLES));

/** Σ x_k e^(2πi jk / SAMPLES) in place, by halves (Cooley and Tukey 1965). */
function transform(real: Float64Array, imaginary: Float64Array): void {
  for (let at = 1, reversed = 0; at < SAMPLES; at++) {
    let bit = SAMPLES >> 1;
    for (; reversed & bit; bit >>= 1) reversed ^= bit;
    reversed ^= bit;
    if (at >= reversed) continue;
    for (const part of [real, imaginary]) [part[at], part[reversed]] = [part[reversed]!, part[at]!];
  }
  for (let half = 1; half < SAMPLES; half *= 2)
    for (let start = 0; start < SAMPLES; start += 2 * half)
      for (let k = 0; k < half; k++) {
        const [low, high, turn] = [start + k, start + k + half, (k * WAVES) / half];
        const x = real[high]! * COSINES[turn]! - imaginary[high]! * SINES[turn]!;
        const y = real[high]! * SINES[turn]! + imaginary[high]! * COSINES[turn]!;
        real[high] = real[low]! - x;
        imaginary[high] = imaginary[low]! - y;
        real[low]! += x;
        imaginary[low]! += y;
      }
}

/** Bumps [ROWS, SAMPLES] of heights from 0.5 to 1.5 and half to one and a half times a length, by chance. */
function places(perMetre: number, length: number, stream: number): Float64Array {
  const found = new Float64Array(ROWS * SAMPLES);
  const chance = (perMetre * STEP) / 1000;
  if (chance <= 0) return found;
  const begins = randomNumbers(stream, SAMPLES);
  const longer = randomNumbers(stream + 8, SAMPLES);
  const higher = randomNumbers(stream + 16, SAMPLES);
  begins.forEach((number, at) => {
    if (number >= chance) return;
    const half = 0.5 * Math.max((length * (0.5 + longer[at]!)) / STEP, 1);
    const [row, column] = [at - (at % SAMPLES), at % SAMPLES];
    for (let step = -Math.ceil(half); step <= Math.ceil(half); step++) {
      if (Math.abs(step) >= half) continue;
      const bump = 0.5 + 0.5 * Math.cos((Math.PI * step) / half);
      found[row + ((column + step + SAMPLES) % SAMPLES)]! += (0.5 + higher[at]!) * bump;
    }
  });
  return found;
}

/** Takes the mean of each row off. */
function centred(rows: Float64Array): Float64Array {
  for (let row = 0; row < rows.length; row += SAMPLES) {
    const mean = pairwiseSum(rows, row, SAMPLES) / SAMPLES;
    for (let at = row; at < row + SAMPLES; at++) rows[at]! -= mean;
  }
  return rows;
}

/** Relative mass less 1, of mean 0. */
const thicknessOf = remembered(
  (massCv: number, fibreLength: number, thickPlaces: number, thickLength: number, thickSize: number) => {
    const mass = waves(massSpectrum(massCv, fibreLength), IRREGULAR_THICKNESS_STREAM);
    const thick = places(thickPlaces, thickLength, IRREGULAR_THICK_STREAM).map((height) => thickSize * height);
    const mean = pairwiseSum(thick) / thick.length;
    return centred(mass.map((value, at) => Math.max(value + thick[at]! - mean, IRREGULAR_LEAST_THICKNESS)));
  },
);

/** Relative width less 1, of mean 0, of yarn that covers a share of its cell, and cannot be wider than that. */
function coverOf(thickness: Float64Array, cover: number): Float64Array {
  const root = thickness.map((value) => Math.sqrt(1 + Math.max(value, IRREGULAR_LEAST_THICKNESS)));
  const bounded = new Float64Array(root.length);
  let [low, high] = [0.5, 2];
  for (let step = 0; step < 40; step++) {
    const middle = 0.5 * (low + high);
    for (let at = 0; at < root.length; at++) bounded[at] = Math.min(middle * cover * root[at]!, 1);
    if (pairwiseSum(bounded) / bounded.length < cover) low = middle;
    else high = middle;
  }
  return centred(root.map((value) => Math.min(high * cover * value, 1) / cover - 1));
}

/** Depth of shade, of mean 0; positive is darker. The first five numbers are those of `thicknessOf`. */
const toneOf = remembered((...numbers: [number, number, number, number, number, number, number, number, number]) => {
  const [massCv, fibreLength, thickPlaces, thickLength, thickSize, shade, melange, perGain, colourNoise] = numbers;
  const thickness = thicknessOf(massCv, fibreLength, thickPlaces, thickLength, thickSize);
  // A spread of ±1 has the deviation 1/√3.
  const lots = (colourNoise / Math.sqrt(3)) * perGain;
  const of = (amount: number, part: (f: number) => number): Float64Array => {
    const spectrum = FREQUENCIES.map(part);
    const total = pairwiseSum(spectrum);
    return spectrum.map((value) => (amount ** 2 * value) / total);
  };
  const parts = [
    waves(of(shade, (f) => 1 / f), IRREGULAR_SHADE_STREAM),
    waves(of(melange, (f) => (f > 1 / IRREGULAR_MELANGE_LENGTH ? 1 : 0)), IRREGULAR_MELANGE_STREAM),
    waves(of(lots, (f) => (f < 1 / IRREGULAR_LOT_LENGTH ? 1 : 0)), IRREGULAR_LOT_STREAM),
  ] as const;
  const found = centred(
    parts[0].map((value, at) => {
      const wider = Math.sqrt(1 + Math.max(thickness[at]!, IRREGULAR_LEAST_THICKNESS)) - 1;
      const total = value + parts[1][at]! + parts[2][at]!;
      return Math.tanh((total - IRREGULAR_RELIEF * perGain * wider) / IRREGULAR_LARGEST_TONE);
    }),
  );
  let most = 1;
  for (const value of found) most = Math.max(most, Math.abs(value));
  return found.map((value) => (IRREGULAR_LARGEST_TONE * value) / most);
});

/** Share of the yarn that neps cover less its mean. */
const nepOf = remembered((neps: number, length: number) =>
  centred(places(neps, length, IRREGULAR_NEP_STREAM).map((height) => Math.min(height, 1))),
);

// ----------------------------------------------------------------------------------------------------- the tables

/**
 * The table of a family; the same object for the same numbers.
 *
 * @param cover mean share of a cell that the yarn covers.
 * @param perGain see `depthPerGain`.
 * @param colourNoise relative spread of the albedo from thread to thread.
 */
export function irregularTable(yarn: Irregularity, cover: number, perGain: number, colourNoise: number): IrregularTable {
  const { mass_cv, fibre_length, thick_places, thick_length, thick_size, shade, melange, neps, nep_length } = yarn;
  // Families that differ less share a table.
  const roundCover = rint(1000 * cover) / 1000;
  const roundGain = rint(10 * perGain) / 10;
  const numbers = [mass_cv, fibre_length, thick_places, thick_length, thick_size, shade, melange] as const;
  return tableOf(...numbers, neps, nep_length, roundCover, roundGain, colourNoise);
}

const tableOf = remembered(
  (
    massCv: number,
    fibreLength: number,
    thickPlaces: number,
    thickLength: number,
    thickSize: number,
    shade: number,
    melange: number,
    neps: number,
    nepLength: number,
    cover: number,
    perGain: number,
    colourNoise: number,
  ): IrregularTable => {
    const thickness = thicknessOf(massCv, fibreLength, thickPlaces, thickLength, thickSize);
    const mass = [massCv, fibreLength, thickPlaces, thickLength, thickSize] as const;
    const tone = toneOf(...mass, shade, melange, perGain, colourNoise);
    const process = [thickness, coverOf(thickness, cover), tone, nepOf(neps, nepLength)];
    const integrals = new Int32Array((ROWS + BLOCK + 1) * SAMPLES * QUANTITIES);
    const units = process.map((rows, quantity) => {
      const { sums, unit } = integralsOf(rows);
      // The first row is 0.
      for (let at = 0; at < sums.length; at++) integrals[(SAMPLES + at) * QUANTITIES + quantity] = sums[at]!;
      return unit;
    });
    return { integrals: new Uint32Array(integrals.buffer), units: units as [number, number, number, number] };
  },
);

/** Integrals of a quantity over threads and steps before [ROWS + BLOCK, SAMPLES], in units. */
interface Integrals {
  readonly sums: Int32Array;
  readonly unit: number;
}

// Of the processes that are remembered.
const integralsKnown = new WeakMap<Float64Array, Integrals>();
// Numbers beyond which doubles are whole: adding it rounds as `rint` does, and quickly.
const WHOLE = 1.5 * 2 ** 52;

function integralsOf(rows: Float64Array): Integrals {
  const known = integralsKnown.get(rows);
  if (known !== undefined) return known;
  const exact = new Float64Array((ROWS + BLOCK) * SAMPLES);
  const before = new Float64Array(SAMPLES);
  let most = 1e-12;
  for (let row = 0; row < ROWS + BLOCK; row++) {
    // Blocks that begin in the last rows go on with the first.
    const from = (row % ROWS) * SAMPLES;
    let sum = 0;
    for (let column = 0; column < SAMPLES; column++) {
      // Each row is 0 in all, so the integral at the ring's end is that at its beginning.
      exact[row * SAMPLES + column] = sum;
      most = Math.max(most, Math.abs(sum));
      before[column]! += rows[from + column]!;
      sum += before[column]!;
    }
  }
  const unit = most / IRREGULAR_LARGEST_INTEGRAL;
  const sums = new Int32Array(exact.length);
  for (let at = 0; at < exact.length; at++) sums[at] = exact[at]! / unit + WHOLE - WHOLE;
  const found = { sums, unit };
  integralsKnown.set(rows, found);
  return found;
}

/** Mean share of a cell that the yarns of a family cover. */
export function coverOfThreads(threads: FamilyTables): number {
  return pairwiseSum(threads.halfWidth.map((half) => 2 * half)) / threads.period;
}

/** Change of the depth of shade over the relative change of the albedo that it makes, of the threads of a family. */
export function depthPerGain(albedos: Float64Array): number {
  const diffuse: number[] = [];
  for (let thread = 0; thread < albedos.length; thread += ALBEDO_NUMBERS)
    for (let channel = 0; channel < 3; channel++) diffuse.push(albedos[thread + channel]! + albedos[thread + 3 + channel]!);
  const albedo = clamp(pairwiseSum(diffuse) / diffuse.length, 0, 0.9);
  return (1 + albedo) / (1 - albedo);
}
