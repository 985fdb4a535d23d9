/** A mesh of the user's own: OBJ, PLY, GLB and glTF by three.js' loaders, which are fetched when one is opened. */
import { InputError } from "loomlight-fabric";
import type { Mesh } from "loomlight-web";

import type { Server } from "../api.ts";
import { ownShape, type ClothShape } from "./meshes.ts";

/** The side, in millimetres, that a mesh is taken to have where its unit is unlikely to be the metre. */
const LIKELY_MM = 600;

/** Larger meshes take minutes to read here, and their triangles are smaller than pixels. */
const MAX = 64 * 2 ** 20;

/** What Python alone reads. */
const READ_BY_PYTHON = /\.usd[acz]?$/i;

/** A mesh as a piece of cloth, and in a sentence what of it is no cloth. */
export interface OwnMesh {
  readonly shape: ClothShape;
  readonly warnings: readonly string[];
}

/**
 * The mesh in a file, all its parts with uv as one piece of cloth. Parts without, as buttons, stay bare, as `render --mesh`
 * has them: here they are not drawn, but cast shadows. A mesh without uv, and USD, is read by the server, which cuts it into pieces.
 *
 * @throws InputError a file that is too large, no mesh, one without triangles, or one that needs the server where there is none.
 */
export async function readOwnMesh(file: File, server: Server | null): Promise<OwnMesh> {
  if (file.size > MAX)
    throw new InputError(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB; meshes of up to ${MAX >> 20} MiB are read: simplify it.`);
  if (READ_BY_PYTHON.test(file.name)) return readByServer(file, server, "is read");
  const parts = await geometriesOf(file);
  const [covered, bare] = [parts.filter(hasUv), parts.filter((part) => !hasUv(part))];
  if (covered.length === 0 && bare.length > 0)
    return readByServer(file, server, "has no uv, or they collapse to lines or points, and is cut into pieces");
  const mesh = merged(covered, file.name);
  const triangles = bare.reduce((sum, part) => sum + trianglesOf(part), 0);
  const parted = bare.length === 1 ? "A part" : `${bare.length} parts`;
  const warnings =
    triangles === 0 ? [] : [`${parted} of ${file.name} without uv, ${triangles} triangles, ${bare.length === 1 ? "wears" : "wear"} no cloth, and cast${bare.length === 1 ? "s" : ""} only a shadow here.`];
  return { shape: scaled(mesh, bare.length === 0 ? null : merged(bare, file.name), file.name), warnings };
}

async function readByServer(file: File, server: Server | null, what: string): Promise<OwnMesh> {
  if (server === null || !server.hasPython)
    throw new InputError(`${file.name} ${what} by \`loomlight view\`, which this page runs without: open it there, or what \`loomlight render --save-mesh\` writes.`);
  const { mesh, bare, warnings } = serverMeshOf(await server.mesh(file));
  return { shape: scaled(mesh, bare, file.name), warnings };
}

/** What the server made of a mesh; `viewer/mesh_message.py` says how it lies. */
export function serverMeshOf(content: ArrayBuffer): { mesh: Mesh; bare: Mesh | null; warnings: string[] } {
  const size = new DataView(content).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(content, 4, size))) as {
    vertices: number;
    triangles: number;
    bareVertices: number;
    bareTriangles: number;
    warnings: string[];
  };
  let at = 4 + size;
  const take = (count: number): number => (at += 4 * count) - 4 * count;
  const floats = (count: number): Float32Array<ArrayBuffer> => new Float32Array(content, take(count), count);
  const words = (count: number): Uint32Array<ArrayBuffer> => new Uint32Array(content, take(count), count);
  const { vertices, bareVertices } = head;
  const [positions, normals, uv] = [floats(3 * vertices), floats(3 * vertices), floats(2 * vertices)];
  const [barePositions, bareNormals] = [floats(3 * bareVertices), floats(3 * bareVertices)];
  const [triangles, bareTriangles] = [words(3 * head.triangles), words(3 * head.bareTriangles)];
  const bare = { positions: barePositions, normals: bareNormals, uv: new Float32Array(2 * bareVertices), triangles: bareTriangles };
  return { mesh: { positions, normals, uv, triangles }, bare: bareVertices === 0 ? null : bare, warnings: head.warnings };
}

export interface Geometry {
  readonly attributes: Readonly<Record<string, { readonly array: ArrayLike<number>; readonly count: number } | undefined>>;
  readonly index: { readonly array: ArrayLike<number> } | null;
  computeVertexNormals(): void;
}

function trianglesOf({ attributes, index }: Geometry): number {
  return Math.floor((index?.array.length ?? attributes["position"]?.count ?? 0) / 3);
}

/** Whether a part has uv that span an area. */
export function hasUv({ attributes, index }: Geometry): boolean {
  const uv = attributes["uv"]?.array;
  const count = attributes["position"]?.count ?? 0;
  if (uv === undefined) return false;
  const corners = index?.array ?? Array.from({ length: count }, (_, vertex) => vertex);
  for (let at = 0; at + 2 < corners.length; at += 3) {
    const [a, b, c] = [corners[at]!, corners[at + 1]!, corners[at + 2]!];
    const [du, dv] = [uv[b * 2]! - uv[a * 2]!, uv[b * 2 + 1]! - uv[a * 2 + 1]!];
    const [eu, ev] = [uv[c * 2]! - uv[a * 2]!, uv[c * 2 + 1]! - uv[a * 2 + 1]!];
    if (Math.abs(du * ev - dv * eu) > 0) return true;
  }
  return false;
}

async function geometriesOf(file: File): Promise<Geometry[]> {
  const root = await loaded(file);
  const geometries: Geometry[] = [];
  root.updateMatrixWorld(true);
  root.traverse((part) => {
    const { geometry, matrixWorld } = part as unknown as {
      geometry?: Geometry & { clone(): Geometry & { applyMatrix4(matrix: unknown): void } };
      matrixWorld: unknown;
    };
    if (geometry === undefined || (part as { isMesh?: boolean }).isMesh !== true) return;
    const placed = geometry.clone();
    placed.applyMatrix4(matrixWorld);
    geometries.push(placed);
  });
  return geometries;
}

interface Node {
  updateMatrixWorld(force: boolean): void;
  traverse(visit: (part: object) => void): void;
}

async function loaded(file: File): Promise<Node> {
  try {
    if (/\.obj$/i.test(file.name)) {
      const { OBJLoader } = await import("three/addons/loaders/OBJLoader.js");
      return new OBJLoader().parse(await file.text());
    }
    if (/\.ply$/i.test(file.name)) {
      const { PLYLoader } = await import("three/addons/loaders/PLYLoader.js");
      const { Mesh: Part } = await import("three");
      return new Part(new PLYLoader().parse(await file.arrayBuffer())) as unknown as Node;
    }
    const { GLTFLoader } = await import("three/addons/loaders/GLTFLoader.js");
    const scene = await new GLTFLoader().parseAsync(await file.arrayBuffer(), "");
    return scene.scene;
  } catch {
    throw new InputError(`${file.name} is damaged or no mesh: OBJ, PLY and GLB are read.`);
  }
}

function merged(geometries: readonly Geometry[], name: string): Mesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const uv: number[] = [];
  const triangles: number[] = [];
  for (const geometry of geometries) {
    if (geometry.attributes["normal"] === undefined) geometry.computeVertexNormals();
    const { position, normal, uv: coordinates } = geometry.attributes;
    if (position === undefined || normal === undefined) continue;
    const first = positions.length / 3;
    for (let at = 0; at < position.count * 3; at++) {
      positions.push(position.array[at]!);
      normals.push(normal.array[at]!);
    }
    for (let at = 0; at < position.count * 2; at++) uv.push(coordinates?.array[at] ?? 0);
    const corners = geometry.index?.array ?? Array.from({ length: position.count }, (_, vertex) => vertex);
    for (let at = 0; at < corners.length; at++) triangles.push(first + corners[at]!);
  }
  if (triangles.length === 0) throw new InputError(`${name} holds no triangles.`);
  if (!positions.every(Number.isFinite)) throw new InputError(`${name} holds numbers that are not finite.`);
  return { positions, normals, uv, triangles };
}

/** Millimetres per unit of uv: the root of the mesh's area over that of its uv, in a mesh brought to a likely size. */
function scaled(mesh: Mesh, bare: Mesh | null, name: string): ClothShape {
  const whole = ownShape(mesh, [100, 100]);
  const isMetres = whole.radius > 0.02 && whole.radius < 3;
  const factor = isMetres ? 1 : LIKELY_MM / 2000 / whole.radius;
  const sizedOf = (part: Mesh): Mesh => (isMetres ? part : { ...part, positions: Array.from(part.positions, (value) => value * factor) });
  const sized = sizedOf(mesh);
  const side = 1000 * Math.sqrt(areaRatio(sized));
  const shape = { ...ownShape(sized, [side, side]), file: { name, metresPerUnit: factor } };
  return bare === null ? shape : { ...shape, casters: [sizedOf(bare)] };
}

function areaRatio(mesh: Mesh): number {
  let surface = 0;
  let flat = 0;
  const { positions, uv, triangles } = mesh;
  for (let face = 0; face < triangles.length; face += 3) {
    const [a, b, c] = [triangles[face]!, triangles[face + 1]!, triangles[face + 2]!];
    const edge = (from: number, to: number): [number, number, number] => [
      positions[to * 3]! - positions[from * 3]!,
      positions[to * 3 + 1]! - positions[from * 3 + 1]!,
      positions[to * 3 + 2]! - positions[from * 3 + 2]!,
    ];
    const [p, q] = [edge(a, b), edge(a, c)];
    surface += Math.hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]) / 2;
    const [du, dv] = [uv[b * 2]! - uv[a * 2]!, uv[b * 2 + 1]! - uv[a * 2 + 1]!];
    const [eu, ev] = [uv[c * 2]! - uv[a * 2]!, uv[c * 2 + 1]! - uv[a * 2 + 1]!];
    flat += Math.abs(du * ev - dv * eu) / 2;
  }
  return flat > 0 ? surface / flat : 0.01;
}
