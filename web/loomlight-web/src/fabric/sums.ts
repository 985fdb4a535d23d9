/** Sums and products of numbers, in the order in which NumPy adds them, so that tables of both are alike. */

const BLOCK = 128;

/** The sum of `count` numbers from `first` on, pairwise as NumPy's: rounding grows with the logarithm of the count. */
export function pairwiseSum(values: ArrayLike<number>, first = 0, count = values.length): number {
  if (count < 8) {
    let sum = 0;
    for (let i = 0; i < count; i++) sum += values[first + i]!;
    return sum;
  }
  if (count <= BLOCK) {
    const parts = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => values[first + i]!);
    const whole = count - (count % 8);
    for (let i = 8; i < whole; i += 8) for (let k = 0; k < 8; k++) parts[k]! += values[first + i + k]!;
    const [a, b, c, d, e, f, g, h] = parts as [number, number, number, number, number, number, number, number];
    let sum = a + b + (c + d) + (e + f + (g + h));
    for (let i = whole; i < count; i++) sum += values[first + i]!;
    return sum;
  }
  const half = Math.floor(count / 2);
  const left = half - (half % 8);
  return pairwiseSum(values, first, left) + pairwiseSum(values, first + left, count - left);
}

/** The largest of the numbers. */
export function largest(values: ArrayLike<number>): number {
  let found = -Infinity;
  for (let i = 0; i < values.length; i++) found = Math.max(found, values[i]!);
  return found;
}

/** The smallest difference `upper[i] − lower[i]`. */
export function smallestStep(lower: ArrayLike<number>, upper: ArrayLike<number>): number {
  let found = Infinity;
  for (let i = 0; i < lower.length; i++) found = Math.min(found, upper[i]! - lower[i]!);
  return found;
}
