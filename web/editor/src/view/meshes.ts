/** The pieces of cloth that can be shown: metres, y up, uv to scale over the whole piece. */
import { clamp, InputError } from "loomlight-fabric";
import type { Caster, Ground, Mesh } from "loomlight-web";

import drapeAddress from "../assets/drape.bin?url";
import type { Shape } from "../state/document.ts";

/** A piece, how large its unit of uv is, and where a camera sees it well. */
export interface ClothShape {
  readonly mesh: Mesh;
  /** Parts that are no cloth. */
  readonly casters?: readonly Caster[];
  readonly uvSizeMm: readonly [number, number];
  /** Centre and radius of a ball around the piece, metres. */
  readonly centre: readonly [number, number, number];
  readonly radius: number;
  /** The direction from the centre to the camera that frames it. */
  readonly from: readonly [number, number, number];
  /** The plane that it stands on, or lies on as in `mitsuba/scenes.py`. */
  readonly ground: Omit<Ground, "lampShare">;
  /** Of the user's own: its file, and the length of one of its units as it is shown. */
  readonly file?: { readonly name: string; readonly metresPerUnit: number };
}

type Place = (u: number, v: number) => [number, number, number];

const SPHERE_RADIUS = 0.1;
/** The cap reaches behind the sphere's outline, so that a camera over its pole sees cloth only. */
const SPHERE_CAP = (115 * Math.PI) / 180;
const CYLINDER_RADIUS = 0.04;
const CYLINDER_LENGTH = 0.12;
const CURTAIN_SIZE = [0.2, 0.12] as const;
const CURTAIN_FOLDS = 4;
/** Amplitude of the folds' slope. */
const CURTAIN_SLOPE = 0.8;
/** Vertices a side, and units a metre, of the draped cloth in its file. */
const DRAPE_SIDE = 128;
const DRAPE_UNITS = 65534;
const DRAPE_MM = 600;
/** From a piece that lies to the plane behind it, metres. */
const SWATCH_GAP = 0.004;
const GAP = 0.001;

/** One of the built-in pieces; "mesh" is the user's own and is none of them. */
export async function builtInShape(shape: Exclude<Shape, "mesh">): Promise<ClothShape> {
  switch (shape) {
    case "drape":
      return draped();
    case "flat":
      return piece(surface(2, (u, v) => [0.1 * (u - 0.5), 0.1 * (v - 0.5), 0]), [100, 100], [0, 0, 1], SWATCH_GAP);
    case "sphere":
      return ball();
    case "cylinder":
      return piece(
        surface(257, (u, v) => {
          const angle = 2 * Math.PI * (v - 0.5);
          return [CYLINDER_LENGTH * (u - 0.5), CYLINDER_RADIUS * Math.sin(angle), CYLINDER_RADIUS * Math.cos(angle)];
        }),
        [CYLINDER_LENGTH * 1000, 2 * Math.PI * CYLINDER_RADIUS * 1000],
        [0.15, 0.25, 1],
        GAP,
      );
    case "curtain":
      return curtain();
  }
}

/** A piece with the uv size and the view of a mesh of the user's own. */
export function ownShape(mesh: Mesh, uvSizeMm: readonly [number, number]): ClothShape {
  return piece(mesh, uvSizeMm, [0.3, 0.35, 1]);
}

async function draped(): Promise<ClothShape> {
  const response = await fetch(drapeAddress);
  if (!response.ok) throw new InputError("The draped cloth could not be loaded: reload the page.");
  const view = new DataView(await response.arrayBuffer());
  const last = DRAPE_SIDE - 1;
  const vertex = (column: number, row: number, axis: number): number =>
    view.getInt16(((row * DRAPE_SIDE + column) * 3 + axis) * 2, true) / DRAPE_UNITS;
  const grid = surface(DRAPE_SIDE, (u, v) => {
    const column = Math.round(clamp(u, 0, 1) * last);
    const row = Math.round(clamp(v, 0, 1) * last);
    return [vertex(column, row, 0), vertex(column, row, 1), vertex(column, row, 2)];
  });
  return piece(grid, [DRAPE_MM, DRAPE_MM], [0.35, 0.55, 1]);
}

/** Radii are kept and circles about the middle are gathered, as draped cloth does; a disc of the square of uv. */
function ball(): ClothShape {
  const reach = SPHERE_RADIUS * SPHERE_CAP;
  const square = surface(193, (u, v) => {
    const [x, y] = [reach * (2 * u - 1), reach * (2 * v - 1)];
    const angle = Math.hypot(x, y) / SPHERE_RADIUS;
    const ratio = angle < 1e-9 ? 1 : Math.sin(angle) / angle;
    return [x * ratio, y * ratio, SPHERE_RADIUS * Math.cos(angle)];
  });
  const { uv, triangles } = square;
  const inside: number[] = [];
  for (let face = 0; face < triangles.length; face += 3) {
    const corners = [triangles[face]!, triangles[face + 1]!, triangles[face + 2]!];
    const mean = (axis: number): number => corners.reduce((sum, corner) => sum + uv[corner * 2 + axis]!, 0) / 3;
    if (Math.hypot(2 * mean(0) - 1, 2 * mean(1) - 1) <= 1) inside.push(...corners);
  }
  const size = 2000 * reach;
  return piece({ ...square, triangles: Uint32Array.from(inside) }, [size, size], [0.1, 0.2, 1], GAP);
}

/** Cloth that hangs in four folds: sines whose length is u, so that the cloth is not stretched. */
function curtain(): ClothShape {
  const steps = 4000;
  const lengths = new Float64Array(steps + 1);
  for (let step = 1; step <= steps; step++) {
    const angle = (2 * Math.PI * CURTAIN_FOLDS * (step - 0.5)) / steps;
    lengths[step] = lengths[step - 1]! + Math.hypot(1, CURTAIN_SLOPE * Math.cos(angle));
  }
  const total = lengths[steps]!;
  const width = (CURTAIN_SIZE[0] * steps) / total;
  const depth = (CURTAIN_SLOPE * width) / (2 * Math.PI * CURTAIN_FOLDS);
  const at = (u: number): number => {
    const length = clamp(u, 0, 1) * total;
    let [low, high] = [0, steps];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (lengths[middle]! <= length) low = middle;
      else high = middle;
    }
    return (low + (length - lengths[low]!) / (lengths[high]! - lengths[low]!)) / steps;
  };
  const hung: Place = (u, v) => {
    const place = at(u);
    const fold = depth * Math.sin(2 * Math.PI * CURTAIN_FOLDS * place);
    return [width * (place - 0.5), CURTAIN_SIZE[1] * (v - 0.5), fold];
  };
  return piece(surface([385, 33], hung), [CURTAIN_SIZE[0] * 1000, CURTAIN_SIZE[1] * 1000], [0.25, 0.2, 1]);
}

/** A grid of vertices over the unit square of uv, with normals of central differences over the grid. */
function surface(grid: number | readonly [number, number], place: Place): Mesh {
  const [columns, rows] = typeof grid === "number" ? [grid, grid] : grid;
  const positions = new Float32Array(columns * rows * 3);
  const uv = new Float32Array(columns * rows * 2);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const vertex = row * columns + column;
      const [u, v] = [column / (columns - 1), row / (rows - 1)];
      positions.set(place(u, v), vertex * 3);
      uv.set([u, v], vertex * 2);
    }
  return { positions, normals: gridNormals(positions, columns, rows), uv, triangles: gridTriangles(columns, rows) };
}

function gridNormals(positions: Float32Array, columns: number, rows: number): Float32Array {
  const normals = new Float32Array(positions.length);
  const difference = (from: number, to: number): [number, number, number] => [
    positions[to * 3]! - positions[from * 3]!,
    positions[to * 3 + 1]! - positions[from * 3 + 1]!,
    positions[to * 3 + 2]! - positions[from * 3 + 2]!,
  ];
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const at = (c: number, r: number): number =>
        clamp(r, 0, rows - 1) * columns + clamp(c, 0, columns - 1);
      const a = difference(at(column - 1, row), at(column + 1, row));
      const b = difference(at(column, row - 1), at(column, row + 1));
      const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]] as const;
      const length = Math.hypot(...normal) || 1;
      normals.set(
        normal.map((part) => part / length),
        (row * columns + column) * 3,
      );
    }
  return normals;
}

function gridTriangles(columns: number, rows: number): Uint32Array {
  const triangles = new Uint32Array((columns - 1) * (rows - 1) * 6);
  let at = 0;
  for (let row = 0; row < rows - 1; row++)
    for (let column = 0; column < columns - 1; column++) {
      const corner = row * columns + column;
      triangles.set([corner, corner + 1, corner + columns + 1, corner, corner + columns + 1, corner + columns], at);
      at += 6;
    }
  return triangles;
}

/** A piece that stands on a floor; with a gap it lies before a plane that faces +z. */
function piece(mesh: Mesh, uvSizeMm: ClothShape["uvSizeMm"], from: ClothShape["from"], gap?: number): ClothShape {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < mesh.positions.length; at++) {
    const axis = at % 3;
    low[axis] = Math.min(low[axis]!, mesh.positions[at]!);
    high[axis] = Math.max(high[axis]!, mesh.positions[at]!);
  }
  const centre = low.map((value, axis) => (value + high[axis]!) / 2) as [number, number, number];
  const radius = Math.hypot(...low.map((value, axis) => (high[axis]! - value) / 2));
  const ground: ClothShape["ground"] =
    gap === undefined ? { normal: [0, 1, 0], offset: low[1]! - GAP * radius } : { normal: [0, 0, 1], offset: low[2]! - gap };
  return { mesh, uvSizeMm, centre, radius, from, ground };
}
