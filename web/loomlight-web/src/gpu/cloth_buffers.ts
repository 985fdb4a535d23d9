/** Pieces of cloth in an adapter's buffers: their meshes, their fabrics, and tables that Python packed. */
import { InputError, type Draft, type FabricFields } from "loomlight-fabric";

import type { Openness } from "../fabric/between_yarns.ts";
import { lookOf } from "../fabric/look.ts";
import { MOST_LAYERS } from "../generated.ts";
import { requireMesh } from "../scene/mesh.ts";
import type { Mesh, ModelName, Piece } from "../types.ts";
import type { Device } from "./device.ts";
import { FabricBuffers, type Dressing } from "./fabric_buffers.ts";
import { SceneBuffers } from "./scene_buffers.ts";
import { ServedBuffers, readTables } from "./served_buffers.ts";

const UV_SIZE_MM = [100, 100] as const;

export class ClothBuffers {
  readonly fabrics: FabricBuffers;
  scene: SceneBuffers;
  pieces: readonly Piece[];
  /** What Python packed for `model`, and the bytes that it sent. */
  private served: { readonly buffers: ServedBuffers; readonly content: Uint8Array } | null = null;
  private readonly device: Device;

  /** @throws InputError no piece, a mesh without uv, a fabric that cannot be, or tables beyond the adapter's limits. */
  constructor(device: Device, pieces: readonly Piece[]) {
    if (pieces.length === 0) throw new InputError("A renderer needs at least one piece of cloth.");
    pieces.forEach(({ mesh }) => requireMesh(mesh));
    const looks = pieces.map(({ fields, draft, openness }) => lookOf(fields, draft, openness));
    this.device = device;
    this.pieces = [...pieces];
    this.scene = sceneOf(device, pieces);
    const dressings = pieces.map(
      ({ uvSizeMm }, number): Dressing => ({
        look: looks[number]!,
        uvSizeMm: uvSizeMm ?? UV_SIZE_MM,
        extra: this.scene.maps[number]!,
      }),
    );
    this.fabrics = new FabricBuffers(device, dressings);
  }

  /** Buffers by the names that shaders have for them. */
  get buffers(): Readonly<Record<string, GPUBuffer>> {
    return { ...this.scene.buffers, ...this.shownFabrics.buffers };
  }

  /** Layers of cloth that a pixel can see. */
  get layers(): number {
    return this.shownFabrics.isOpen && !this.scene.isFlat ? MOST_LAYERS : 1;
  }

  /** The tables that Python packed, where they are shown. */
  get servedContent(): Uint8Array | null {
    return this.served?.content ?? null;
  }

  /** @throws InputError a mesh without uv, or another number of meshes. */
  setMeshes(meshes: readonly Mesh[]): void {
    if (meshes.length !== this.pieces.length)
      throw new InputError(`${meshes.length} meshes were given for ${this.pieces.length} pieces of cloth.`);
    meshes.forEach(requireMesh);
    const pieces = this.pieces.map((piece, number) => ({ ...piece, mesh: meshes[number]! }));
    const scene = sceneOf(this.device, pieces);
    this.scene.destroy();
    [this.pieces, this.scene] = [pieces, scene];
    this.fabrics.describe(scene.maps);
    this.served?.buffers.describe(scene.maps[0]!);
  }

  /** @throws InputError no such piece, or a fabric that cannot be; nothing changes then. */
  setFabric(number: number, fields: FabricFields, draft: Draft, openness: Openness | null): void {
    const piece = this.pieces[number];
    if (piece === undefined)
      throw new InputError(`piece = ${number} is none of the ${this.pieces.length} pieces of cloth.`);
    this.fabrics.setFabric(number, lookOf(fields, draft, openness));
    this.pieces = this.pieces.map((other, index) => (index === number ? { ...piece, fields, draft, openness } : other));
  }

  /** @throws InputError content that is no tables, or several pieces. */
  setTables(model: ModelName, content: Uint8Array): void {
    if (this.pieces.length !== 1)
      throw new InputError(`${model} shows one piece of cloth here, not ${this.pieces.length}.`);
    const uvSizeMm = this.pieces[0]!.uvSizeMm ?? UV_SIZE_MM;
    const buffers = new ServedBuffers(this.device, readTables(content), uvSizeMm, this.scene.maps[0]!);
    this.leaveTables();
    this.served = { buffers, content };
  }

  /** Goes back to the fabrics that the page packs. */
  leaveTables(): void {
    this.served?.buffers.destroy();
    this.served = null;
  }

  destroy(): void {
    this.leaveTables();
    this.scene.destroy();
    this.fabrics.destroy();
  }

  private get shownFabrics(): FabricBuffers | ServedBuffers {
    return this.served?.buffers ?? this.fabrics;
  }
}

/** Buffers of the meshes and albedo maps of pieces. */
function sceneOf(device: Device, pieces: readonly Piece[]): SceneBuffers {
  return new SceneBuffers(
    device,
    pieces.map(({ mesh }) => mesh),
    pieces.map(({ albedo }) => albedo ?? null),
  );
}
