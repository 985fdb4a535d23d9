/** A directional max-height pyramid, by which rays high above the cloth skip cells; see `yarn/geometry.py`. */
import { PYRAMID_RADII, QUADRANTS, TILE_CELLS } from "../generated.ts";

/**
 * The pyramid [⌈picks / 2⌉, ⌈ends / 2⌉, 4], from the words of warp and weft [picks, ends, 2].
 *
 * A word has a byte for each radius: the maximum level of the front face in the lower half, of the back in the upper.
 */
export function packMaxHeights(words: Uint32Array, picks: number, ends: number): Uint32Array {
  const along = Math.ceil(picks / TILE_CELLS);
  const across = Math.ceil(ends / TILE_CELLS);
  const pyramid = new Uint32Array(along * across * QUADRANTS);
  for (let back = 0; back < 2; back++) {
    const levels = faceLevels(words, back === 1);
    PYRAMID_RADII.forEach((radius, number) => {
      for (const right of [0, 1] as const) {
        const columns = highestOfRows(levels, picks, ends, across, radius, right === 1);
        for (const up of [0, 1] as const)
          for (let row = 0; row < along; row++)
            for (let column = 0; column < across; column++) {
              const [low, high] = windowOf(row, radius, up === 1);
              let highest = 0;
              for (let pick = low; pick < high; pick++)
                highest = Math.max(highest, columns[modulo(pick, picks) * across + column]!);
              const at = (row * across + column) * QUADRANTS + right + 2 * up;
              pyramid[at] = (pyramid[at]! | (highest << (8 * number + 4 * back))) >>> 0;
            }
      }
    });
  }
  return pyramid;
}

/** Level of the thread that is nearest to the viewer of a face [picks·ends]. */
function faceLevels(words: Uint32Array, back: boolean): Uint8Array {
  return Uint8Array.from({ length: words.length / 2 }, (_, crossing) => {
    const isWarp = ((words[2 * crossing]! & 1) === 1) !== back;
    return words[2 * crossing + (isWarp ? 0 : 1)]! >>> 28;
  });
}

/** Maxima along each row [picks, across] of tiles and of `radius` cells to the right of them, else to the left. */
function highestOfRows(
  levels: Uint8Array,
  picks: number,
  ends: number,
  across: number,
  radius: number,
  right: boolean,
): Uint8Array {
  const highest = new Uint8Array(picks * across);
  for (let pick = 0; pick < picks; pick++)
    for (let column = 0; column < across; column++) {
      const [low, high] = windowOf(column, radius, right);
      let found = 0;
      for (let end = low; end < high; end++) found = Math.max(found, levels[pick * ends + modulo(end, ends)]!);
      highest[pick * across + column] = found;
    }
  return highest;
}

/** Cells of a tile and of `radius` cells ahead of it, else behind it: the first one, and one past the last. */
function windowOf(tile: number, radius: number, ahead: boolean): [number, number] {
  const first = TILE_CELLS * tile;
  return ahead ? [first, first + TILE_CELLS + radius] : [first - radius, first + TILE_CELLS];
}

function modulo(value: number, period: number): number {
  return ((value % period) + period) % period;
}
