/** How fine a picture may be so that it follows the hand, from the time that passes took. */

// Divisors of the canvas's sides.
const DIVISORS = [1, 1.5, 2, 3, 4, 6, 8] as const;
// Share of the newest measurement in the mean.
const NEWEST = 0.5;

/** Milliseconds that a pass may take. */
export interface Budget {
  /** While something moves. */
  readonly moving: number;
  /** At rest. */
  readonly resting: number;
}

export const BUDGET: Budget = { moving: 30, resting: 1000 };

/**
 * Chooses the divisor of the canvas's sides for each pass.
 *
 * While something moves, a pass takes at most the budget's `moving`. At rest pictures become finer, by half at each
 * pass, until the finest within `resting` is reached, where passes then add up.
 */
export class Pace {
  divisor: number = DIVISORS.at(-1)!;
  private readonly budget: Budget;
  /** Milliseconds a pixel; null before the first measurement. */
  private cost: number | null = null;

  constructor(budget: Budget = BUDGET) {
    this.budget = budget;
  }

  /** A pass over so many pixels took so many milliseconds. */
  measured(ms: number, pixels: number): void {
    const cost = ms / Math.max(pixels, 1);
    this.cost = this.cost === null ? cost : this.cost + NEWEST * (cost - this.cost);
  }

  /** Something changed: the divisor for the next pass. */
  moved(pixels: number): void {
    this.divisor = this.within(pixels, this.budget.moving);
  }

  /** Nothing changed: whether the next pass is finer, and so begins anew. */
  rested(pixels: number): boolean {
    const finest = this.within(pixels, this.budget.resting);
    if (this.cost === null || this.divisor <= finest) return false;
    this.divisor = Math.max(finest, this.divisor / 2);
    return true;
  }

  private within(pixels: number, ms: number): number {
    const cost = this.cost;
    if (cost === null) return DIVISORS.at(-1)!;
    return DIVISORS.find((divisor) => (cost * pixels) / divisor ** 2 <= ms) ?? DIVISORS.at(-1)!;
  }
}
