/** Pointer, wheel and keys that move a camera about a piece of cloth, from the whole piece to a single yarn. */
import { closerBy, moved, orbitBetween, orbitCamera, turned, type Camera, type Orbit, type Vector3 } from "loomlight-web";

import { framing } from "./framing.ts";
import type { ClothShape } from "./meshes.ts";
import { hitDistance } from "./ray_mesh.ts";

/** From here a picture is about five threads wide. */
const NEAREST = 0.004;
/** The farthest view, in distances of the whole piece. */
const FARTHEST = 4;
/** Zoom of a wheel's unit, and of a key. */
const WHEEL = 1.0015;
const KEY_ZOOM = 1.15;
/** Of a key, in shares of the picture. */
const KEY_TURN = 0.03;

export class OrbitControl {
  private orbit: Orbit = orbitBetween([0, 0, 0.3], [0, 0, 0]);
  private shape: ClothShape | null = null;
  /** Where the camera framed the shape: while it stands there, another size of the picture frames it again. */
  private framed: Orbit | null = null;
  private readonly element: HTMLElement;
  private readonly pointers = new Map<number, { x: number; y: number }>();

  constructor(element: HTMLElement) {
    this.element = element;
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    const release = (event: PointerEvent): void => void this.pointers.delete(event.pointerId);
    element.addEventListener("pointerup", release);
    element.addEventListener("pointercancel", release);
    element.addEventListener("pointermove", (event) => this.drag(event, Math.min(element.clientWidth, element.clientHeight)));
    element.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoomBy(WHEEL ** -event.deltaY);
      },
      { passive: false },
    );
    element.addEventListener("keydown", (event) => {
      if (!this.press(event.key, event.shiftKey)) return;
      event.preventDefault();
    });
  }

  get place(): Orbit {
    return this.orbit;
  }

  get camera(): Camera {
    return orbitCamera(this.orbit);
  }

  /** 0 is across the room, 1 a single yarn. */
  get zoom(): number {
    const { distance, nearest, farthest } = this.orbit;
    return Math.log(farthest / distance) / Math.log(farthest / nearest);
  }

  set zoom(zoom: number) {
    const { distance, nearest, farthest } = this.orbit;
    this.zoomBy(distance / (farthest * (nearest / farthest) ** zoom));
  }

  /** Frames a piece of cloth. */
  frame(shape: ClothShape): void {
    this.shape = shape;
    const { clientWidth, clientHeight } = this.element;
    const { origin, target } = framing(shape.mesh.positions, shape.from, Math.max(clientWidth, 1), Math.max(clientHeight, 1));
    const away = Math.hypot(...origin.map((value, axis) => value - target[axis]!));
    this.orbit = { ...orbitBetween(origin, target, NEAREST), farthest: FARTHEST * away };
    this.focus();
    this.framed = this.orbit;
  }

  /** The picture has another size. */
  resized(): void {
    if (this.shape !== null && this.orbit === this.framed) this.frame(this.shape);
  }

  /** Turns about what lies in the middle of the picture. */
  private focus(): void {
    if (this.shape === null) return;
    const { origin } = this.camera;
    const towards = this.orbit.target.map((value, axis) => value - origin[axis]!) as unknown as Vector3;
    const share = hitDistance(this.shape.mesh, origin, towards);
    if (share === null || share * this.orbit.distance < this.orbit.nearest) return;
    const target = origin.map((value, axis) => value + share * towards[axis]!) as unknown as Vector3;
    this.orbit = { ...this.orbit, target, distance: share * this.orbit.distance };
  }

  private zoomBy(ratio: number): void {
    this.focus();
    this.orbit = closerBy(this.orbit, ratio);
  }

  private drag(event: PointerEvent, side: number): void {
    const before = this.pointers.get(event.pointerId);
    if (before === undefined) return;
    const now = { x: event.clientX, y: event.clientY };
    const [right, down] = [(now.x - before.x) / side, (now.y - before.y) / side];
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, now);
    if (other !== undefined) {
      const apart = (point: { x: number; y: number }): number => Math.max(Math.hypot(point.x - other.x, point.y - other.y), 1);
      this.orbit = closerBy(moved(this.orbit, right / 2, down / 2), apart(now) / apart(before));
    } else if (event.shiftKey || event.buttons === 2 || event.buttons === 4) this.orbit = moved(this.orbit, right, down);
    else this.orbit = turned(this.orbit, right, down);
  }

  private press(key: string, shift: boolean): boolean {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key];
    if (step !== undefined) {
      const [right, down] = [KEY_TURN * step[0]!, KEY_TURN * step[1]!];
      this.orbit = shift ? moved(this.orbit, right, down) : turned(this.orbit, right, down);
    } else if (key === "+" || key === "=") this.zoomBy(KEY_ZOOM);
    else if (key === "-") this.zoomBy(1 / KEY_ZOOM);
    else if (key === "0" && this.shape !== null) this.frame(this.shape);
    else return false;
    return true;
  }
}
