/** How fine a picture may be so that it follows the hand, and how much of it one submission takes, from times of passes. */

// Divisors of the canvas's sides.
const DIVISORS = [1, 1.5, 2, 3, 4, 6, 8, 12, 16] as const;
// Share of a measurement in the mean where it is below: a dear part of the picture is not to come as a surprise.
const SINKS = 0.4;
// Pixels of a submission: before the first measurement, and at least.
const FIRST_PIXELS = 1024;
const MIN_PIXELS = 1024;
// A submission has so many times the pixels of the one before at most: it may meet a dearer part.
const GROWS = 4;
// What a row of groups of `tone_map` takes.
const MAX_PIXELS = 64 * 65535;

/** Milliseconds. */
export interface Budget {
  /** Of a pass while something moves. */
  readonly moving: number;
  /** Of one submission to the adapter: a software adapter, and the page with it, stands still meanwhile. */
  readonly submission: number;
  /** Of all passes of a picture at rest; one is made however long it takes. */
  readonly resting: number;
}

export const BUDGET: Budget = { moving: 30, submission: 200, resting: 180_000 };

/**
 * Chooses the divisor of the canvas's sides for each picture, and how many pixels one submission shades.
 *
 * While something moves, a pass takes at most the budget's `moving`. At rest pictures become finer, by half at each
 * pass, as long as a pass is one submission; the finest is then made of several.
 */
export class Pace {
  divisor: number = DIVISORS.at(-1)!;
  private readonly budget: Budget;
  /** Milliseconds a pixel; null before the first measurement. */
  private cost: number | null = null;
  /** Pixels of late submissions. */
  private late = FIRST_PIXELS / GROWS;

  constructor(budget: Budget = BUDGET) {
    this.budget = budget;
  }

  /** A submission of so many pixels took so many milliseconds. */
  measured(ms: number, pixels: number): void {
    this.late = Math.max(pixels, this.late / 2);
    const cost = ms / Math.max(pixels, 1);
    this.cost = this.cost === null || cost > this.cost ? cost : this.cost + SINKS * (cost - this.cost);
  }

  /** Something changed: the divisor for the next pass. */
  moved(pixels: number): void {
    this.divisor = this.within(pixels, this.budget.moving);
  }

  /** Nothing changed: whether the next picture is finer, and still of one submission a pass. */
  rested(pixels: number): boolean {
    const finest = this.within(pixels, this.budget.submission);
    if (this.cost === null || this.divisor <= finest) return false;
    this.divisor = Math.max(finest, this.divisor / 2);
    return true;
  }

  /** Pixels that one submission may shade. */
  get pixels(): number {
    if (this.cost === null) return FIRST_PIXELS;
    return Math.min(MAX_PIXELS, GROWS * this.late, Math.max(MIN_PIXELS, this.budget.submission / this.cost));
  }

  /** Milliseconds that a pass of so many pixels takes; 0 before the first measurement. */
  expected(pixels: number): number {
    return (this.cost ?? 0) * pixels;
  }

  /** Passes of so many pixels that a picture at rest has time for, 1 to `most`. */
  passes(pixels: number, most: number): number {
    const time = this.expected(pixels);
    return time > 0 ? Math.min(most, Math.max(1, Math.floor(this.budget.resting / time))) : most;
  }

  private within(pixels: number, ms: number): number {
    return DIVISORS.find((divisor) => this.cost !== null && this.expected(pixels) / divisor ** 2 <= ms) ?? DIVISORS.at(-1)!;
  }
}
