/** Meshes of a scene: what is asked of them, and simple ones. */
import { InputError } from "loomlight-fabric";

import { RecordArray } from "../records.ts";
import type { Caster, Mesh } from "../types.ts";

/**
 * A mesh that can be rendered, or an error that says what it lacks.
 *
 * @throws InputError no uv, arrays of different vertices, a face of a vertex that is not there, or numbers not finite.
 */
export function requireMesh(mesh: Mesh): void {
  const count = mesh.positions.length / 3;
  if (!Number.isInteger(count) || mesh.normals.length !== 3 * count)
    throw new InputError("A mesh needs positions and normals [n, 3] of the same vertices.");
  if (mesh.uv.length !== 2 * count)
    throw new InputError("The mesh has no uv for each vertex; unwrap it, as they place the weave on it.");
  requireFaces(mesh);
  for (const numbers of [mesh.normals, mesh.uv]) requireFinite(numbers);
}

/**
 * Faces that can be met by rays.
 *
 * @throws InputError no face, a face of a vertex that is not there, or numbers not finite.
 */
export function requireFaces(mesh: Caster): void {
  const count = mesh.positions.length / 3;
  const corners = mesh.triangles.length;
  if (corners === 0 || corners % 3 !== 0)
    throw new InputError("A mesh needs faces [m, 3], three vertices each, at least one.");
  for (let corner = 0; corner < corners; corner++)
    if (!(mesh.triangles[corner]! >= 0 && mesh.triangles[corner]! < count))
      throw new InputError(`A face of the mesh names a vertex outside 0 to ${count - 1}.`);
  requireFinite(mesh.positions);
}

function requireFinite(numbers: ArrayLike<number>): void {
  for (let i = 0; i < numbers.length; i++)
    if (!Number.isFinite(numbers[i])) throw new InputError("The mesh holds numbers that are not finite.");
}

/** A rectangle in the plane z = 0 about the origin, metres; u along x and v along y, 0 to 1. */
export function rectangle(width: number, height: number): Mesh {
  const [x, y] = [width / 2, height / 2];
  return {
    positions: [-x, -y, 0, x, -y, 0, x, y, 0, -x, y, 0],
    normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
    uv: [0, 0, 1, 0, 1, 1, 0, 1],
    triangles: [0, 1, 2, 0, 2, 3],
  };
}

/** Buffers of several meshes as one. */
export interface MeshBuffers {
  readonly vertices: RecordArray;
  /** Three vertices of each face, then the number of the piece of each face [4·faces]. */
  readonly corners: Uint32Array<ArrayBuffer>;
  readonly positions: Float64Array;
  readonly faces: number;
  /** Those of cloth, which come first, and their vertices. */
  readonly shown: { readonly faces: number; readonly vertices: number };
}

/** The meshes of all pieces behind each other, then what casts shadows on them, which is of no piece. */
export function joinMeshes(pieces: readonly Mesh[], casters: readonly Caster[]): MeshBuffers {
  const meshes: readonly (Caster & Partial<Mesh>)[] = [...pieces, ...casters];
  const sum = (of: readonly Caster[], name: keyof Caster): number => of.reduce((total, mesh) => total + mesh[name].length / 3, 0);
  const [count, faces] = [sum(meshes, "positions"), sum(meshes, "triangles")];
  const vertices = new RecordArray("Vertex", count);
  const floats = new Float32Array(vertices.words.buffer);
  const corners = new Uint32Array(4 * faces);
  const positions = new Float64Array(3 * count);
  let firstVertex = 0;
  let firstFace = 0;
  meshes.forEach((mesh, number) => {
    const piece = Math.min(number, pieces.length);
    const own = mesh.positions.length / 3;
    for (let vertex = 0; vertex < own; vertex++) {
      const at = 8 * (firstVertex + vertex);
      for (let axis = 0; axis < 3; axis++) {
        floats[at + axis] = mesh.positions[3 * vertex + axis]!;
        floats[at + 3 + axis] = mesh.normals?.[3 * vertex + axis] ?? 0;
        positions[3 * (firstVertex + vertex) + axis] = mesh.positions[3 * vertex + axis]!;
      }
      floats[at + 6] = mesh.uv?.[2 * vertex] ?? 0;
      floats[at + 7] = mesh.uv?.[2 * vertex + 1] ?? 0;
    }
    for (let corner = 0; corner < mesh.triangles.length; corner++)
      corners[3 * firstFace + corner] = firstVertex + mesh.triangles[corner]!;
    const ownFaces = mesh.triangles.length / 3;
    corners.fill(piece, 3 * faces + firstFace, 3 * faces + firstFace + ownFaces);
    firstVertex += own;
    firstFace += ownFaces;
  });
  const shown = { faces: sum(pieces, "triangles"), vertices: sum(pieces, "positions") };
  return { vertices, corners, positions, faces, shown };
}
