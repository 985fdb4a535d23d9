/** Meshes of three.js as the renderer takes them: in the space of the world, metres. */
import { InputError } from "loomlight-fabric";
import { Matrix3, Vector3 } from "three";
import type { Mesh as ThreeMesh, Object3D } from "three";

import type { Caster, Mesh } from "../types.ts";

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
  return { positions, normals, uv: coordinates, triangles: trianglesOf(mesh) };
}

/**
 * The visible meshes of a scene that cast shadows (`castShadow`) and are none of `cloth`. Meshes that bend by bones or
 * morphs, or stand in several places, cast none on cloth.
 */
export function castersOf(scene: Object3D, cloth: ReadonlySet<Object3D>): ThreeMesh[] {
  const found: ThreeMesh[] = [];
  scene.traverseVisible((object) => {
    const mesh = object as ThreeMesh & { isSkinnedMesh?: boolean; isInstancedMesh?: boolean; isBatchedMesh?: boolean };
    if (mesh.isMesh !== true || !mesh.castShadow || cloth.has(mesh)) return;
    if (mesh.isSkinnedMesh === true || mesh.isInstancedMesh === true || mesh.isBatchedMesh === true) return;
    if (mesh.geometry.morphAttributes.position || (mesh.geometry.attributes.position?.count ?? 0) < 3) return;
    found.push(mesh);
  });
  return found;
}

/** What a mesh casts shadows with, where it stands in its scene. */
export function casterOf(mesh: ThreeMesh, metresPerUnit: number): Caster {
  const position = mesh.geometry.attributes.position!;
  const positions = new Float64Array(3 * position.count);
  const vector = new Vector3();
  for (let vertex = 0; vertex < position.count; vertex++)
    vector.fromBufferAttribute(position, vertex).applyMatrix4(mesh.matrixWorld).multiplyScalar(metresPerUnit).toArray(positions, 3 * vertex);
  return { positions, triangles: trianglesOf(mesh) };
}

function trianglesOf({ geometry: { index, attributes } }: ThreeMesh): Uint32Array {
  const corners = index?.count ?? attributes.position!.count;
  return Uint32Array.from({ length: corners - (corners % 3) }, (_, corner) => (index === null ? corner : index.getX(corner)));
}
