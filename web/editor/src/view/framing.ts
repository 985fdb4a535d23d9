/** The nearest camera that shows a whole piece of cloth, centred in its picture; as `mitsuba/camera.py:framing`. */
import { FIELD_OF_VIEW, type Vector3 } from "loomlight-web";

/** Of the distance that fills the picture, so that a margin is left. */
const MARGIN = 1.05;

/**
 * Where a camera stands and what it looks at, to see all `positions` [n·3] from the direction `from` in a picture of
 * so many pixels.
 */
export function framing(
  positions: ArrayLike<number>,
  from: Vector3,
  width: number,
  height: number,
): { readonly origin: Vector3; readonly target: Vector3 } {
  const length = Math.hypot(...from);
  const backward = from.map((value) => value / length) as unknown as Vector3;
  // Of the horizon, and upwards in the picture.
  const across = Math.hypot(backward[0], backward[2]);
  const right: Vector3 = across > 1e-9 ? [backward[2] / across, 0, -backward[0] / across] : [1, 0, 0];
  const up: Vector3 = [
    backward[1] * right[2] - backward[2] * right[1],
    backward[2] * right[0] - backward[0] * right[2],
    backward[0] * right[1] - backward[1] * right[0],
  ];
  const slope = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / Math.min(width, height);
  const [slopeX, slopeY] = [slope * width, slope * height];
  const high = { x: -Infinity, left: -Infinity, y: -Infinity, low: -Infinity, far: Infinity, near: -Infinity };
  for (let at = 0; at < positions.length; at += 3) {
    const dot = (axis: Vector3): number => positions[at]! * axis[0] + positions[at + 1]! * axis[1] + positions[at + 2]! * axis[2];
    const [x, y, z] = [dot(right), dot(up), dot(backward)];
    high.x = Math.max(high.x, x + slopeX * z);
    high.left = Math.max(high.left, -x + slopeX * z);
    high.y = Math.max(high.y, y + slopeY * z);
    high.low = Math.max(high.low, -y + slopeY * z);
    high.far = Math.min(high.far, z);
    high.near = Math.max(high.near, z);
  }
  // Each pair of opposite points bounds the distance; half their sum centres them in perspective.
  const distance = Math.max((high.x + high.left) / (2 * slopeX), (high.y + high.low) / (2 * slopeY));
  const depth = (high.far + high.near) / 2;
  const [x, y] = [(high.x - high.left) / 2, (high.y - high.low) / 2];
  const at = (z: number): Vector3 => right.map((value, axis) => x * value + y * up[axis]! + z * backward[axis]!) as unknown as Vector3;
  return { origin: at(depth + (distance - depth) * MARGIN), target: at(depth) };
}
