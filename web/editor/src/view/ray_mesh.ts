/** Where a ray meets a mesh: what the camera is turned about. */
import type { Mesh, Vector3 } from "loomlight-web";

/**
 * Distance along the ray, in lengths of `direction`, to the nearest triangle, from either side; null beside the mesh
 * (Möller and Trumbore 1997).
 */
export function hitDistance(mesh: Mesh, origin: Vector3, direction: Vector3): number | null {
  const { positions, triangles } = mesh;
  let nearest = Infinity;
  const [ox, oy, oz] = origin;
  const [dx, dy, dz] = direction;
  for (let face = 0; face < triangles.length; face += 3) {
    const [a, b, c] = [triangles[face]! * 3, triangles[face + 1]! * 3, triangles[face + 2]! * 3];
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
    const [ux, uy, uz] = [positions[b]! - ax, positions[b + 1]! - ay, positions[b + 2]! - az];
    const [vx, vy, vz] = [positions[c]! - ax, positions[c + 1]! - ay, positions[c + 2]! - az];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) continue;
    const [tx, ty, tz] = [ox - ax, oy - ay, oz - az];
    const first = (tx * px + ty * py + tz * pz) / determinant;
    if (first < 0 || first > 1) continue;
    const [qx, qy, qz] = [ty * uz - tz * uy, tz * ux - tx * uz, tx * uy - ty * ux];
    const second = (dx * qx + dy * qy + dz * qz) / determinant;
    if (second < 0 || first + second > 1) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / determinant;
    if (distance > 0 && distance < nearest) nearest = distance;
  }
  return nearest === Infinity ? null : nearest;
}
