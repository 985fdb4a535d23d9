/** A bounding volume hierarchy over triangles: a complete binary tree, split at medians; see `realtime/scene.py`. */
import { FACES_A_LEAF, NO_FACE } from "../generated.ts";

export interface Hierarchy {
  /** Lower and upper corners of node 1, 2, 3 … [2·leaves − 1, 6]; below node n are 2n and 2n + 1. */
  readonly boxes: Float32Array<ArrayBuffer>;
  /** [leaves, 4]; `NO_FACE` for none. */
  readonly leafFaces: Uint32Array<ArrayBuffer>;
  /** A power of 2. */
  readonly leaves: number;
}

// Boxes of nothing are a point far away: shading languages may take infinite numbers for NaN.
const NOWHERE = 1e30;

/** The hierarchy of triangles: every node is split at the median of its longest side. */
export function buildHierarchy(positions: ArrayLike<number>, corners: ArrayLike<number>, faces: number): Hierarchy {
  const low = new Float64Array(3 * faces);
  const high = new Float64Array(3 * faces);
  const centres = new Float64Array(3 * faces);
  for (let face = 0; face < faces; face++)
    for (let axis = 0; axis < 3; axis++) {
      const values = [0, 1, 2].map((corner) => positions[3 * corners[3 * face + corner]! + axis]!);
      const at = 3 * face + axis;
      low[at] = Math.min(...values);
      high[at] = Math.max(...values);
      centres[at] = (low[at]! + high[at]!) / 2;
    }
  const depth = Math.max(0, Math.ceil(Math.log2(faces / FACES_A_LEAF)));
  const leaves = 1 << depth;
  const leafFaces = new Uint32Array(leaves * FACES_A_LEAF).fill(NO_FACE);
  const boxes = new Float64Array(6 * 2 * leaves);
  const all = Uint32Array.from({ length: faces }, (_, face) => face);
  const place = (node: number, members: Uint32Array): void => {
    const box = boxes.subarray(6 * node, 6 * node + 6);
    if (node >= leaves) {
      leafFaces.set(members, (node - leaves) * FACES_A_LEAF);
      boxOf(members, low, high, box);
      return;
    }
    const axis = longestAxis(members, centres);
    const sorted = members.slice().sort((a, b) => centres[3 * a + axis]! - centres[3 * b + axis]!);
    const half = Math.floor((members.length + 1) / 2);
    place(2 * node, sorted.subarray(0, half));
    place(2 * node + 1, sorted.subarray(half));
    const [left, right] = [boxes.subarray(12 * node, 12 * node + 6), boxes.subarray(12 * node + 6, 12 * node + 12)];
    for (let axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(left[axis]!, right[axis]!);
      box[3 + axis] = Math.max(left[3 + axis]!, right[3 + axis]!);
    }
  };
  place(1, all);
  for (let node = 1; node < 2 * leaves; node++)
    if (boxes[6 * node]! > boxes[6 * node + 3]!) boxes.fill(NOWHERE, 6 * node, 6 * node + 6);
  return { boxes: Float32Array.from(boxes.subarray(6)), leafFaces, leaves };
}

function boxOf(members: Uint32Array, low: Float64Array, high: Float64Array, box: Float64Array): void {
  box.fill(Infinity, 0, 3).fill(-Infinity, 3);
  for (const face of members)
    for (let axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(box[axis]!, low[3 * face + axis]!);
      box[3 + axis] = Math.max(box[3 + axis]!, high[3 * face + axis]!);
    }
}

/** The axis along which centres extend farthest; the first of equals. */
function longestAxis(members: Uint32Array, centres: Float64Array): number {
  let found = 0;
  let longest = 0;
  for (let axis = 0; axis < 3; axis++) {
    let [least, most] = [Infinity, -Infinity];
    for (const face of members) {
      least = Math.min(least, centres[3 * face + axis]!);
      most = Math.max(most, centres[3 * face + axis]!);
    }
    if (most - least > longest) [found, longest] = [axis, most - least];
  }
  return found;
}
