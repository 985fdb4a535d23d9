/**
 * Cloth in a scene of three.js.
 *
 * The clothed meshes are rendered by WebGPU with three's camera and lights into a picture of their own, and three draws
 * them with a material that shows this picture where they are on the screen. So three's own depth test decides what
 * hides what, holes show what three drew behind them, and any renderer of three will do.
 */
import { CanvasTexture, LinearFilter, SRGBColorSpace, Vector2, Vector4 } from "three";
import type { Camera as ThreeCamera, Material, Mesh as ThreeMesh, Scene, Texture } from "three";

import type { Fabric } from "../fabric_source.ts";
import { ClothRenderer, type RendererOptions } from "../renderer.ts";
import type { Caster, Environment, LinearPicture } from "../types.ts";
import { cameraOf } from "./camera.ts";
import { lightsOf } from "./lights.ts";
import { casterOf, castersOf, meshOf } from "./mesh.ts";

/** How a fabric lies on a mesh. */
export interface ClothOptions {
  /** Millimetres per unit of u and of v; 100 by default. */
  readonly uvSizeMm?: readonly [number, number];
  /** Diffuse albedos are multiplied by this picture over the unit of uv. */
  readonly albedo?: LinearPicture;
}

/** How a layer is made. */
export interface LayerOptions extends Omit<RendererOptions, "canvas" | "size" | "transparent" | "shareWith"> {
  /** Metres per unit of the scene; 1 by default. */
  readonly metresPerUnit?: number;
  /** Light from all directions, in place of that of ambient and hemisphere lights. */
  readonly environment?: Environment;
}

/** What renderers of three have in common, as far as a layer asks. */
export interface ThreeRenderer {
  getDrawingBufferSize(target: Vector2): Vector2;
  getCurrentViewport?(target: Vector4): Vector4;
}

/** The part of the screen that a view fills: left, bottom, width, height, pixels. */
export type Viewport = readonly [number, number, number, number];

/** A material that shows a picture at the place of each pixel on the screen. */
export interface ScreenMaterial {
  readonly material: Material;
  setViewport(viewport: Viewport): void;
}

/** A mesh that a layer clothes. */
export interface Clothing {
  readonly mesh: ThreeMesh;
  readonly layer: ClothLayer;
  /** Another fabric, or an edit of it: only what changes is baked. */
  setFabric(fabric: Fabric): void;
  /** Gives the mesh its former material back. */
  remove(): void;
}

interface Member {
  readonly mesh: ThreeMesh;
  readonly options: ClothOptions;
  fabric: Fabric;
  readonly before: { readonly material: ThreeMesh["material"]; readonly hook: ThreeMesh["onBeforeRender"] };
  /** The mesh's place when its positions were last given to the renderer. */
  place: string;
}

/** The clothed meshes of one scene, seen by one camera. */
export class ClothLayer {
  readonly renderer: ClothRenderer;
  /** Whether a further frame would change the picture: render again until it is so. */
  isComplete = false;
  private readonly canvas: OffscreenCanvas;
  private readonly texture: Texture;
  private readonly screen: ScreenMaterial;
  private readonly options: LayerOptions;
  private members: Member[] = [];
  private casters: readonly Caster[] = [];
  /** Where what casts shadows was when it was last given to the renderer. */
  private cast = "";
  private lit = "";
  private isUpdated = false;
  private isChanged = false;

  private constructor(
    renderer: ClothRenderer,
    canvas: OffscreenCanvas,
    options: LayerOptions,
    screenMaterial: (picture: Texture) => ScreenMaterial,
  ) {
    this.renderer = renderer;
    this.canvas = canvas;
    this.options = options;
    this.texture = new CanvasTexture(canvas as unknown as HTMLCanvasElement);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.generateMipmaps = false;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    // Colours of the picture are multiplied by the share of cloth already.
    this.texture.premultiplyAlpha = true;
    this.screen = screenMaterial(this.texture);
    renderer.setBackground([0, 0, 0]);
    if (options.environment !== undefined) renderer.setEnvironment(options.environment);
    this.followLosses();
  }

  /**
   * A layer whose meshes are shown by a material of the kind that three's renderer takes.
   *
   * @throws InputError no WebGPU, no adapter, or one whose limits are too small.
   */
  static async create(
    screenMaterial: (picture: Texture) => ScreenMaterial,
    options: LayerOptions = {},
  ): Promise<ClothLayer> {
    const canvas = new OffscreenCanvas(1, 1);
    const renderer = await ClothRenderer.create({ ...options, canvas, transparent: true });
    return new ClothLayer(renderer, canvas, options, screenMaterial);
  }

  /**
   * Clothes a mesh with a fabric; its material is put aside.
   *
   * @throws InputError a mesh without uv or normals, or a fabric that cannot be.
   */
  clothe(mesh: ThreeMesh, fabric: Fabric, options: ClothOptions = {}): Clothing {
    const before = { material: mesh.material, hook: mesh.onBeforeRender };
    const member: Member = { mesh, fabric, options, before, place: "" };
    this.setMembers([...this.members.filter((other) => other.mesh !== mesh), member]);
    mesh.material = this.screen.material;
    mesh.onBeforeRender = (three, scene, camera, ...rest) => {
      before.hook.call(mesh, three, scene, camera, ...rest);
      this.update(three, scene, camera);
    };
    return {
      mesh,
      layer: this,
      setFabric: (other) => {
        this.renderer.setFabric(this.members.indexOf(member), other.fields, other.draft);
        member.fabric = other;
        this.isChanged = true;
      },
      remove: () => {
        [mesh.material, mesh.onBeforeRender] = [before.material, before.hook];
        this.setMembers(this.members.filter((other) => other !== member));
      },
    };
  }

  /** Draws the picture for a view of three; three calls it for each clothed mesh, and the first call draws. */
  update(three: ThreeRenderer, scene: Scene, camera: ThreeCamera): void {
    if (this.isUpdated || this.members.length === 0) return;
    this.isUpdated = true;
    queueMicrotask(() => (this.isUpdated = false));
    const viewport = viewportOf(three);
    const [, , width, height] = viewport;
    if (width !== this.canvas.width || height !== this.canvas.height) {
      this.renderer.resize(width, height);
      this.texture.dispose(); // its size on three's side is fixed
    }
    this.screen.setViewport(viewport);
    this.followMeshes(scene);
    this.followLights(scene);
    this.renderer.setCamera(cameraOf(camera, width, height, this.metres));
    const wasComplete = this.isComplete;
    this.isComplete = this.renderer.frame().isComplete;
    if (!wasComplete || !this.isComplete || this.isChanged) this.texture.needsUpdate = true;
    this.isChanged = false;
  }

  /** Takes the cloth off all meshes, and gives everything back to the adapter. */
  dispose(): void {
    for (const { mesh, before } of this.members) [mesh.material, mesh.onBeforeRender] = [before.material, before.hook];
    this.members = [];
    this.texture.dispose();
    this.screen.material.dispose();
    this.renderer.destroy();
  }

  private get metres(): number {
    return this.options.metresPerUnit ?? 1;
  }

  private setMembers(members: Member[]): void {
    const pieces = members.map(({ mesh, fabric, options }) => ({
      mesh: meshOf(mesh, this.metres),
      fields: fabric.fields,
      draft: fabric.draft,
      ...options,
    }));
    if (pieces.length > 0) this.renderer.setPieces(pieces, this.casters);
    for (const member of members) member.place = placeOf(member.mesh);
    this.members = members;
    this.isChanged = true;
  }

  /** Gives the renderer the positions of meshes, and of what casts shadows on them, again where one has moved. */
  private followMeshes(scene: Scene): void {
    const casters = castersOf(scene, new Set(this.members.map(({ mesh }) => mesh)));
    const cast = casters.map(placeOf).join(";");
    if (cast === this.cast && this.members.every((member) => member.place === placeOf(member.mesh))) return;
    if (cast !== this.cast) this.casters = casters.map((mesh) => casterOf(mesh, this.metres));
    this.cast = cast;
    this.renderer.setMeshes(this.members.map(({ mesh }) => meshOf(mesh, this.metres)), this.casters);
    for (const member of this.members) member.place = placeOf(member.mesh);
  }

  private followLights(scene: Scene): void {
    const { lights, environment } = lightsOf(scene, this.metres);
    const lit = JSON.stringify([lights, environment?.picture.pixels]);
    if (lit === this.lit) return;
    this.lit = lit;
    this.renderer.setLights(lights);
    if (this.options.environment === undefined) this.renderer.setEnvironment(environment);
  }

  private followLosses(): void {
    void this.renderer.lost.then(async () => {
      await this.renderer.rebuild();
      this.isChanged = true;
      this.followLosses();
    });
  }
}

/** What tells whether a mesh is where it was: its matrix, and the versions of its attributes. */
function placeOf(mesh: ThreeMesh): string {
  const { position, normal } = mesh.geometry.attributes;
  const versions = [position, normal].map((attribute) =>
    attribute !== undefined && "version" in attribute ? attribute.version : 0,
  );
  return [mesh.geometry.id, ...versions, ...mesh.matrixWorld.elements].join();
}

function viewportOf(three: ThreeRenderer): Viewport {
  if (three.getCurrentViewport !== undefined) {
    const { x, y, z, w } = three.getCurrentViewport(new Vector4());
    return [x, y, Math.max(1, Math.round(z)), Math.max(1, Math.round(w))];
  }
  const { x, y } = three.getDrawingBufferSize(new Vector2());
  return [0, 0, Math.max(1, Math.round(x)), Math.max(1, Math.round(y))];
}
