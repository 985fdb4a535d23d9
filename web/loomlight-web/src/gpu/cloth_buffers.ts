/** Pieces of cloth in an adapter's buffers: their meshes, their fabrics, and tables that Python packed. */
import { InputError, type Draft, type FabricFields } from "loomlight-fabric";

import type { Openness } from "../fabric/between_yarns.ts";
import { lookOf, type Look } from "../fabric/look.ts";
import { sameLayout } from "../fabric/pack.ts";
import { MAX_LAYERS } from "../generated.ts";
import { requireFaces, requireMesh } from "../scene/mesh.ts";
import type { Caster, Mesh, ModelName, Piece } from "../types.ts";
import type { Device } from "./device.ts";
import { FabricBuffers, type Dressing } from "./fabric_buffers.ts";
import { bakeOpenness, isAsOpen } from "./openness_baker.ts";
import { SceneBuffers } from "./scene_buffers.ts";
import type { TableCache } from "./table_cache.ts";
import { ServedBuffers, readTables } from "./served_buffers.ts";

const UV_SIZE_MM = [100, 100] as const;

/** What was found of how open a piece of cloth is, and the look that it was found of. */
interface KnownOpenness {
  readonly look: Look;
  readonly openness: Openness;
}

export class ClothBuffers {
  readonly fabrics: FabricBuffers;
  scene: SceneBuffers;
  pieces: readonly Piece[];
  casters: readonly Caster[];
  /** What Python packed for `model`, and the bytes that it sent. */
  private served: { readonly buffers: ServedBuffers; readonly content: Uint8Array } | null = null;
  private readonly device: Device;
  /** How often the openness of a fabric was found here. */
  openings = 0;
  /** By the number of the piece. */
  private readonly known = new Map<number, KnownOpenness>();
  private readonly finding = new Map<number, Promise<void>>();
  private isDestroyed = false;
  /** Whether rays came back from no adapter: cloth is then shown by direct light. */
  private isUnknowable = false;

  /** @throws InputError no piece, a mesh without uv, a fabric that cannot be, or tables beyond the adapter's limits. */
  constructor(device: Device, pieces: readonly Piece[], casters: readonly Caster[], cache: TableCache | null = null) {
    if (pieces.length === 0) throw new InputError("A renderer needs at least one piece of cloth.");
    pieces.forEach(({ mesh }) => requireMesh(mesh));
    casters.forEach(requireFaces);
    const looks = pieces.map(({ fields, draft, openness }) => lookOf(fields, draft, openness));
    this.device = device;
    this.pieces = [...pieces];
    this.casters = casters;
    this.scene = sceneOf(device, pieces, casters);
    const dressings = pieces.map(
      ({ uvSizeMm }, number): Dressing => ({
        look: looks[number]!,
        uvSizeMm: uvSizeMm ?? UV_SIZE_MM,
        extra: this.scene.maps[number]!,
      }),
    );
    this.fabrics = new FabricBuffers(device, dressings, cache);
  }

  /** Buffers by the names that shaders have for them. */
  get buffers(): Readonly<Record<string, GPUBuffer>> {
    return { ...this.scene.buffers, ...this.shownFabrics.buffers };
  }

  /** Layers of cloth that a pixel can see. */
  get layers(): number {
    return this.shownFabrics.isOpen && !this.scene.isFlat ? MAX_LAYERS : 1;
  }

  /** Whether the openness of all pieces that need it is that of their yarns. */
  get isSettled(): boolean {
    return this.isUnknowable || this.served !== null || this.pieces.every((_, number) => this.isFound(number));
  }

  /**
   * Looks for the openness of pieces with light between their yarns that came without it. Until it is there, a piece
   * that was edited keeps the one that it had.
   *
   * @param onFound is called when the cloth has become another.
   * @returns false while a piece has none.
   */
  findOpenness(onFound: () => void): boolean {
    if (this.device.fault("bake_openness") !== undefined) this.isUnknowable = true;
    if (this.isUnknowable || this.served !== null) return true;
    this.pieces.forEach((_, number) => {
      if (this.isFound(number) || this.finding.has(number)) return;
      const { look, highest } = this.fabrics.lookAt(number);
      const openness = bakeOpenness(this.device, this.fabrics.buffers, number, look, highest);
      if (openness === undefined) return;
      const found = openness
        .then((value) => this.keepOpenness(number, { look, openness: value }))
        .catch(() => {
          this.isUnknowable = true;
        })
        .then(() => {
          this.finding.delete(number);
          if (!this.isDestroyed) onFound();
        });
      this.finding.set(number, found);
    });
    return this.pieces.every((piece, number) => !looksForOpenness(piece) || this.known.has(number));
  }

  /** Resolves when what is being looked for is found, and what is baked is done. */
  async found(): Promise<void> {
    await Promise.all([...this.finding.values(), this.fabrics.settled()]);
  }

  /** The tables that Python packed, where they are shown. */
  get servedContent(): Uint8Array | null {
    return this.served?.content ?? null;
  }

  /** Whether what is shown has layers: those of Python alone, as the page finds none in a drawdown. */
  get isLayered(): boolean {
    return this.served?.buffers.isLayered ?? false;
  }

  /** @throws InputError a mesh without uv, or another number of meshes. */
  setMeshes(meshes: readonly Mesh[], casters: readonly Caster[]): void {
    if (meshes.length !== this.pieces.length)
      throw new InputError(`${meshes.length} meshes were given for ${this.pieces.length} pieces of cloth.`);
    meshes.forEach(requireMesh);
    casters.forEach(requireFaces);
    const pieces = this.pieces.map((piece, number) => ({ ...piece, mesh: meshes[number]! }));
    const scene = sceneOf(this.device, pieces, casters);
    this.scene.destroy();
    [this.pieces, this.casters, this.scene] = [pieces, casters, scene];
    this.fabrics.describe(scene.maps);
    this.served?.buffers.describe(scene.maps[0]!);
  }

  /** @throws InputError no such piece, or a fabric that cannot be; nothing changes then. */
  setFabric(number: number, fields: FabricFields, draft: Draft, openness: Openness | null | undefined): void {
    const piece = this.pieces[number];
    if (piece === undefined)
      throw new InputError(`piece = ${number} is none of the ${this.pieces.length} pieces of cloth.`);
    const known = openness === undefined ? this.known.get(number)?.openness : openness;
    const look = lookOf(fields, draft, known);
    const { look: before } = this.fabrics.lookAt(number);
    // An edit of colours keeps what is known of the yarns.
    const joint = look.joint ?? (sameLayout(look.layout, before.layout) ? before.joint : null);
    this.fabrics.setFabric(number, { ...look, joint });
    const { openness: _, ...rest } = piece;
    const edited = openness === undefined ? { ...rest, fields, draft } : { ...rest, fields, draft, openness };
    this.pieces = this.pieces.map((other, index) => (index === number ? edited : other));
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
    this.isDestroyed = true;
    this.leaveTables();
    this.scene.destroy();
    this.fabrics.destroy();
  }

  private isFound(number: number): boolean {
    if (!looksForOpenness(this.pieces[number]!)) return true;
    const known = this.known.get(number);
    return known !== undefined && isAsOpen(known.look, this.fabrics.lookAt(number).look);
  }

  private keepOpenness(number: number, found: KnownOpenness): void {
    if (this.isDestroyed) return;
    this.known.set(number, found);
    this.openings++;
    const { fields, draft, openness } = this.pieces[number]!;
    this.setFabric(number, fields, draft, openness);
  }

  private get shownFabrics(): FabricBuffers | ServedBuffers {
    return this.served?.buffers ?? this.fabrics;
  }
}

/** Whether the openness of a piece is to be found here: its maker may know it, or want direct light alone. */
function looksForOpenness({ fields, openness }: Piece): boolean {
  return fields.interreflection !== false && openness === undefined;
}

/** Buffers of the meshes and albedo maps of pieces, and of what casts shadows on them. */
function sceneOf(device: Device, pieces: readonly Piece[], casters: readonly Caster[]): SceneBuffers {
  return new SceneBuffers(
    device,
    pieces.map(({ mesh }) => mesh),
    pieces.map(({ albedo }) => albedo ?? null),
    casters,
  );
}
