/** Orders in which threads take shafts, and picks treadles. */

export const ORDERS = ["straight", "reversed", "point", "broken"] as const;
export type Order = (typeof ORDERS)[number];

/**
 * Numbers 1 to `most` for `count` threads.
 *
 * Straight: 1 2 3 4 and again. Reversed: 4 3 2 1. Point: 1 2 3 4 3 2. Broken: 1 2 4 3, half of them upwards and the
 * rest downwards.
 */
export function ordered(order: Order, count: number, most: number): number[] {
  const up = Array.from({ length: most }, (_, index) => index + 1);
  const half = Math.ceil(most / 2);
  const periods: Readonly<Record<Order, readonly number[]>> = {
    straight: up,
    reversed: [...up].reverse(),
    point: [...up, ...up.slice(1, -1).reverse()],
    broken: [...up.slice(0, half), ...up.slice(half).reverse()],
  };
  const period = periods[order];
  return Array.from({ length: count }, (_, thread) => period[thread % period.length]!);
}
