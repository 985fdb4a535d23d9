/** Principal axes of the rows of a matrix, by Jacobi rotations of its 12 × 12 matrix of second moments. */
import { ALBEDO_MIN_AXIS } from "../generated.ts";

export interface PrincipalAxes {
  /** Mean row. */
  readonly mean: Float64Array;
  /** Coordinates within −1 to 1 [n, r]. */
  readonly coordinates: Float64Array;
  /** What a coordinate of 1 adds [r, width]. */
  readonly axes: Float64Array;
  /** r. */
  readonly count: number;
}

const MAX_SWEEPS = 60;

/**
 * Mean, and at most `most` axes, longest first, that change no number by less than 1e-6.
 *
 * The signs of axes are free: they and coordinates change together.
 */
export function principalAxes(rows: Float64Array, width: number, most: number): PrincipalAxes {
  const count = rows.length / width;
  const mean = new Float64Array(width);
  for (let i = 0; i < rows.length; i++) mean[i % width]! += rows[i]! / count;
  const centred = rows.map((value, i) => value - mean[i % width]!);
  const moments = new Float64Array(width * width);
  for (let row = 0; row < count; row++)
    for (let i = 0; i < width; i++)
      for (let j = 0; j < width; j++)
        moments[i * width + j]! += centred[row * width + i]! * centred[row * width + j]!;
  const { vectors } = symmetricEigen(moments, width);
  const kept: { axis: Float64Array; coordinates: Float64Array }[] = [];
  for (const vector of vectors) {
    const coordinates = new Float64Array(count);
    for (let row = 0; row < count; row++)
      for (let i = 0; i < width; i++) coordinates[row]! += centred[row * width + i]! * vector[i]!;
    const size = coordinates.reduce((found, value) => Math.max(found, Math.abs(value)), 0);
    if (kept.length >= most || !(size > ALBEDO_MIN_AXIS)) break;
    kept.push({ axis: vector.map((value) => value * size), coordinates: coordinates.map((value) => value / size) });
  }
  const coordinates = new Float64Array(count * kept.length);
  kept.forEach((part, number) =>
    part.coordinates.forEach((value, row) => (coordinates[row * kept.length + number] = value)),
  );
  const axes = new Float64Array(kept.length * width);
  kept.forEach((part, number) => axes.set(part.axis, number * width));
  return { mean, coordinates, axes, count: kept.length };
}

/** Eigenvalues of a symmetric matrix [n·n] and their unit eigenvectors, the largest first. */
export function symmetricEigen(
  matrix: Float64Array,
  n: number,
): { readonly values: number[]; readonly vectors: Float64Array[] } {
  const a = matrix.slice();
  const v = new Float64Array(n * n);
  for (let i = 0; i < n; i++) v[i * n + i] = 1;
  const total = a.reduce((sum, value) => sum + value * value, 0);
  for (let sweep = 0; sweep < MAX_SWEEPS; sweep++) {
    let outside = 0;
    for (let p = 0; p < n; p++)
      for (let q = p + 1; q < n; q++) {
        outside += a[p * n + q]! ** 2;
        rotate(a, v, n, p, q);
      }
    // Until nothing outside the diagonal is left that double precision resolves.
    if (outside <= 1e-40 * total) break;
  }
  const order = Array.from({ length: n }, (_, k) => k).sort((i, j) => a[j * n + j]! - a[i * n + i]!);
  return {
    values: order.map((k) => a[k * n + k]!),
    vectors: order.map((k) => Float64Array.from({ length: n }, (_, i) => v[i * n + k]!)),
  };
}

/** Rotates rows and columns p and q of a symmetric matrix so that their common element becomes 0. */
function rotate(a: Float64Array, v: Float64Array, n: number, p: number, q: number): void {
  const between = a[p * n + q]!;
  if (between === 0) return;
  const ratio = (a[q * n + q]! - a[p * n + p]!) / (2 * between);
  const tangent = (ratio >= 0 ? 1 : -1) / (Math.abs(ratio) + Math.sqrt(ratio * ratio + 1));
  const cosine = 1 / Math.sqrt(tangent * tangent + 1);
  const sine = tangent * cosine;
  const turn = (m: Float64Array, first: number, second: number): void => {
    const x = m[first]!;
    const y = m[second]!;
    m[first] = cosine * x - sine * y;
    m[second] = sine * x + cosine * y;
  };
  for (let k = 0; k < n; k++) turn(a, k * n + p, k * n + q);
  for (let k = 0; k < n; k++) turn(a, p * n + k, q * n + k);
  for (let k = 0; k < n; k++) turn(v, k * n + p, k * n + q);
}
