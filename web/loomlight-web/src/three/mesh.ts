/** Meshes of three.js as the renderer takes them: in the space of the world, metres. */
import { InputError } from "loomlight-fabric";
import { Matrix3, Vector3 } from "three";
import type { Mesh as ThreeMesh } from "three";

import type { Mesh } from "../types.ts";

/**
 * The mesh where it stands in its scene.
 *
 * @throws InputError no uv or no normals, or a mesh that bends by bones or morphs.
 */
export function meshOf(mesh: ThreeMesh, metresPerUnit: number): Mesh {
  const { position, normal, uv } = mesh.geometry.attributes;
  const name = mesh.name === "" ? "The mesh" : `The mesh "${mesh.name}"`;
  if ((mesh as { isSkinnedMesh?: boolean }).isSkinnedMesh === true || mesh.geometry.morphAttributes.position)
    throw new InputError(`${name} bends by bones or morphs: give a mesh whose vertices stay where they are.`);
  if (position === undefined) throw new InputError(`${name} has no positions.`);
  if (uv === undefined)
    throw new InputError(`${name} has no uv for each vertex; unwrap it, as they place the weave on it.`);
  if (normal === undefined) throw new InputError(`${name} has no normals: call geometry.computeVertexNormals().`);
  mesh.updateWorldMatrix(true, false);
  const turn = new Matrix3().getNormalMatrix(mesh.matrixWorld);
  const positions = new Float64Array(3 * position.count);
  const normals = new Float64Array(3 * position.count);
  const coordinates = new Float64Array(2 * position.count);
  const vector = new Vector3();
  for (let vertex = 0; vertex < position.count; vertex++) {
    vector.fromBufferAttribute(position, vertex).applyMatrix4(mesh.matrixWorld).multiplyScalar(metresPerUnit);
    vector.toArray(positions, 3 * vertex);
    vector.fromBufferAttribute(normal, vertex).applyMatrix3(turn).normalize().toArray(normals, 3 * vertex);
    coordinates.set([uv.getX(vertex), uv.getY(vertex)], 2 * vertex);
  }
  const { index } = mesh.geometry;
  const triangles = Uint32Array.from({ length: index?.count ?? position.count }, (_, corner) =>
    index === null ? corner : index.getX(corner),
  );
  return { positions, normals, uv: coordinates, triangles };
}
