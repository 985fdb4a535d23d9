/** Tables of a layout that shaders read: threads, words of runs, the max-height pyramid. */
import type { ClothLayout } from "./look.ts";
import { packMaxHeights } from "./max_heights.ts";
import { packRuns } from "./runs.ts";
import { finestOf, prepareFamily, type FamilyTables } from "./threads.ts";
import { largest } from "./sums.ts";

export interface Geometry {
  readonly warp: FamilyTables;
  readonly weft: FamilyTables;
  /** Run words of warp and weft at each crossing [picks, ends, 2]. */
  readonly words: Uint32Array;
  /** [⌈picks / 2⌉, ⌈ends / 2⌉, 4]. */
  readonly maxHeights: Uint32Array;
  /** Smallest cells of warp and weft threads, millimetres. */
  readonly finest: readonly [number, number];
}

/** The geometry of one layout. */
export function geometryOf(layout: ClothLayout): Geometry {
  const { ends, picks, warpOnTop } = layout;
  const byEnd = new Uint8Array(ends * picks);
  for (let pick = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++) byEnd[end * picks + pick] = warpOnTop[pick * ends + end]!;
  const warpWords = packRuns(byEnd, ends, picks);
  const weftWords = packRuns(
    warpOnTop.map((up) => 1 - up),
    picks,
    ends,
  );
  const warp = prepareFamily(layout.warp, layout.weft, warpWords);
  const weft = prepareFamily(layout.weft, layout.warp, weftWords);
  const words = new Uint32Array(2 * ends * picks);
  for (let pick = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++) {
      const crossing = pick * ends + end;
      const across = end * picks + pick;
      words[2 * crossing] = warpWords[across]! | (warp.cellMaxima[across]! << 28);
      words[2 * crossing + 1] = weftWords[crossing]! | (weft.cellMaxima[crossing]! << 28);
    }
  return {
    warp,
    weft,
    words,
    maxHeights: packMaxHeights(words, picks, ends),
    finest: [finestOf(warp), finestOf(weft)],
  };
}

/** No thread is ever lower or higher than this, millimetres, on either face. */
export function heightBounds({ warp, weft }: Geometry, layout: ClothLayout): [number, number] {
  const scales = [layout.warp.heightScale, layout.weft.heightScale] as const;
  const dive = Math.max(largest(warp.edgeDrop) * scales[0], largest(weft.edgeDrop) * scales[1]);
  return [
    Math.min(warp.lowest * scales[0], weft.lowest * scales[1]) - dive,
    Math.max(warp.highest * scales[0], weft.highest * scales[1]),
  ];
}
