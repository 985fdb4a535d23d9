/** What a renderer shows and what it tells. Lengths are metres but for `uvSizeMm`; colours are linear RGB. */
import type { Draft, FabricFields } from "loomlight-fabric";

import type { Openness } from "./fabric/between_yarns.ts";

export type Vector3 = readonly [number, number, number];

/** Triangles with normals and uv, as flat arrays. */
export interface Mesh {
  /** [n·3], metres. */
  readonly positions: ArrayLike<number>;
  /** [n·3], unit vectors. */
  readonly normals: ArrayLike<number>;
  /** [n·2]; they place the weave on the mesh. */
  readonly uv: ArrayLike<number>;
  /** [m·3], vertices of each triangle. */
  readonly triangles: ArrayLike<number>;
}

/** A picture, the top row first. */
export interface LinearPicture {
  readonly width: number;
  readonly height: number;
  /** Linear RGB [height·width·3]. */
  readonly pixels: ArrayLike<number>;
}

/** A piece of cloth: a mesh and its fabric. */
export interface Piece {
  readonly mesh: Mesh;
  /** Fields of the fabric, with the keys of a fabric file. */
  readonly fields: FabricFields;
  /** The draft that the fields name, as `loadDraft` returns it. */
  readonly draft: Draft;
  /**
   * What light between yarns needs, unless the fields say `interreflection = false`: the numbers that Python found, or
   * null for direct light alone. Without it the renderer finds them by rays on the adapter.
   */
  readonly openness?: Openness | null;
  /** Millimetres per unit of u and of v; 100 by default. */
  readonly uvSizeMm?: readonly [number, number];
  /** Diffuse albedos are multiplied by this picture, 0 to 1, over the unit of uv, which repeats; v runs down. */
  readonly albedo?: LinearPicture | null;
}

/** What casts shadows on cloth, opaque, and is drawn by others; metres. */
export type Caster = Pick<Mesh, "positions" | "triangles">;

/** Parallel light: `irradiance` on a surface that faces it, W/m²; π by default. */
export interface DirectionalLight {
  readonly kind: "directional";
  /** The direction from which it comes, of any length. */
  readonly towards: Vector3;
  readonly irradiance?: Vector3;
}

/** Light from a point: `intensity` in W/sr. */
export interface PointLight {
  readonly kind: "point";
  readonly position: Vector3;
  readonly intensity: Vector3;
}

export type Light = DirectionalLight | PointLight;

/** Light from all directions: an equirectangular picture; +y is above, columns turn from −z over +x. */
export interface Environment {
  readonly picture: LinearPicture;
  /** Degrees about the vertical. */
  readonly turn?: number;
}

/** A plane where the background takes the shadow of the cloth; it is seen from the side of its normal. */
export interface Ground {
  /** Unit vector. */
  readonly normal: Vector3;
  /** Of the plane from the origin, along the normal, metres. */
  readonly offset: number;
  /** Of the first light in what lights the plane, 0 to 1; the rest comes evenly from all sides. */
  readonly lampShare: number;
}

/** A pinhole camera. */
export interface Camera {
  /** Where it stands. */
  readonly origin: Vector3;
  /** What it looks at. */
  readonly target: Vector3;
  /** What is upwards in the picture; +y by default. */
  readonly up?: Vector3;
  /** Of the picture's shorter side, degrees; 26 by default. */
  readonly fieldOfView?: number;
  /** Nearest distance that is drawn; 0.0001 by default. */
  readonly near?: number;
}

/** `point` samples the footprint of a pixel, the others average over it; Python makes the tables of the last two. */
export type ModelName = "lobes" | "point" | "neural" | "clustered";

/** What a renderer did since it was made; bytes are those that the page sent to the adapter. */
export interface Statistics {
  /** Kernels of baking that were launched, and bakes of a fabric. */
  readonly bakeKernels: number;
  readonly bakes: number;
  /** Times that the openness of a fabric was found, for light between its yarns. */
  readonly openings: number;
  /** Buffers, or parts of them, that were written for fabrics, and their bytes. */
  readonly writes: number;
  readonly writtenBytes: number;
  /** Passes of frames. */
  readonly passes: number;
  /** Milliseconds from handing the last pass over until the adapter had done it; 0 before the first. */
  readonly frameMs: number;
  /** Milliseconds that the last edit took on the page's side. */
  readonly editMs: number;
}

/** What `ClothRenderer.frame` did. */
export interface FrameReport {
  /** Passes that the picture on the canvas is the mean of; 0 while the first shaders compile. */
  readonly passes: number;
  /** Pixels of the picture; fewer than the canvas has while something moves on a slow adapter. */
  readonly width: number;
  readonly height: number;
  /** Share of the canvas that is drawn as fine as it is, 0 to 1; less than 1 where a coarser picture shows through. */
  readonly refined: number;
  /** Whether a further frame would change the picture. */
  readonly isComplete: boolean;
  /** Whether it is a preview: points, without shadows, while what was asked for is compiled or baked. */
  readonly isPreview: boolean;
  /** Share of the shaders that were asked for which are compiled, 0 to 1. */
  readonly compiled: number;
  /** What this device could not compile, a sentence each: the picture goes without it. */
  readonly missing: readonly string[];
}

/** What `ClothRenderer.picture` makes. */
export interface PictureOptions {
  readonly width: number;
  readonly height: number;
  /** That add up; no more are made than the model's pictures take. */
  readonly passes: number;
  /** In place of the renderer's own: linear radiance, or null for the environment. */
  readonly background?: Vector3 | null;
  /** Is told the share that is done. */
  readonly onPass?: (share: number) => void;
}

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** sRGB with an opaque alpha [height·width·4], the top row first. */
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
  /** Mean linear radiance, and the share of each pixel that cloth covers [height·width·4]. */
  readonly linear: Float32Array;
}
