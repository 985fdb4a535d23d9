/** The words of a scene: hierarchy, meshes and albedo maps; environment and lights follow. See `scene_words.py`. */
import { symmetricEigen } from "../fabric/principal_axes.ts";
import { FLAT, RAY_OFFSET } from "../generated.ts";
import type { Values } from "../records.ts";
import type { LinearPicture } from "../types.ts";
import { mapWords } from "./albedo_map.ts";
import { buildHierarchy } from "./hierarchy.ts";
import type { MeshBuffers } from "./mesh.ts";

export interface SceneWords {
  readonly words: Uint32Array;
  /** No face can hide another from a light. */
  readonly isFlat: boolean;
  /** Fields of the record of a frame that say where parts begin. */
  readonly frame: Values;
  /** Of each piece: where its albedo map begins, and its levels. */
  readonly maps: readonly { readonly albedo_map: number; readonly albedo_map_levels: number }[];
}

/** The words of meshes and of the albedo map of each piece. */
export function sceneWords(meshes: MeshBuffers, albedos: readonly (LinearPicture | null)[]): SceneWords {
  const { positions, corners, faces, shown } = meshes;
  const hierarchy = buildHierarchy(positions, corners, faces);
  const parts = [new Uint32Array(hierarchy.boxes.buffer), hierarchy.leafFaces, corners, meshes.vertices.words];
  const leaf_faces = parts[0]!.length;
  const firstCorner = leaf_faces + parts[1]!.length;
  const vertices = firstCorner + corners.length;
  let first = vertices + parts[3]!.length;
  const maps = albedos.map((albedo) => {
    const { words, levels } = albedo === null ? { words: new Uint32Array(0), levels: 0 } : mapWords(albedo);
    const place = { albedo_map: first, albedo_map_levels: levels };
    parts.push(words as Uint32Array<ArrayBuffer>);
    first += words.length;
    return place;
  });
  // Rays leave cloth by a share of its own size, whatever else is around.
  const { isFlat, extent } = extentOf(positions.subarray(0, 3 * shown.vertices));
  return {
    words: joinWords(parts),
    isFlat: isFlat && shown.faces === faces,
    maps,
    frame: {
      leaves: hierarchy.leaves,
      leaf_faces,
      corners: firstCorner,
      face_fabrics: firstCorner + 3 * faces,
      vertices,
      ray_offset: RAY_OFFSET * extent,
      environment_table: first,
    },
  };
}

/** Words behind each other. */
export function joinWords(parts: readonly Uint32Array[]): Uint32Array<ArrayBuffer> {
  const words = new Uint32Array(parts.reduce((sum, part) => sum + part.length, 0));
  let first = 0;
  for (const part of parts) {
    words.set(part, first);
    first += part.length;
  }
  return words;
}

/** Whether all positions lie in a plane, and the largest of their coordinates and extents. */
function extentOf(positions: Float64Array): { isFlat: boolean; extent: number } {
  const count = positions.length / 3;
  const mean = [0, 0, 0];
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    mean[i % 3]! += value / count;
    low[i % 3] = Math.min(low[i % 3]!, value);
    high[i % 3] = Math.max(high[i % 3]!, value);
  });
  const moments = new Float64Array(9);
  for (let vertex = 0; vertex < count; vertex++)
    for (let i = 0; i < 3; i++)
      for (let j = 0; j < 3; j++)
        moments[3 * i + j]! += (positions[3 * vertex + i]! - mean[i]!) * (positions[3 * vertex + j]! - mean[j]!);
  const sizes = symmetricEigen(moments, 3).values.map((value) => Math.sqrt(Math.max(value, 0)));
  const sides = high.map((value, axis) => value - low[axis]!);
  const largest = Math.max(...high.map(Math.abs), ...low.map(Math.abs), ...sides);
  return { isFlat: sizes[2]! <= FLAT * sizes[0]!, extent: largest };
}
