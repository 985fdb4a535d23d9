/** Clothes meshes of scenes that three's WebGPURenderer draws: `loomlight-web/three-webgpu`. */
import { screenUV, texture } from "three/tsl";
import { CustomBlending, DoubleSide, NodeMaterial, OneFactor, OneMinusSrcAlphaFactor } from "three/webgpu";
import type { Mesh, Texture } from "three";

import type { Fabric } from "../fabric_source.ts";
import { ClothLayer, type Clothing, type ClothOptions, type LayerOptions, type ScreenMaterial } from "./cloth_layer.ts";

export { fabricOf, type Fabric } from "../fabric_source.ts";
export { ClothLayer, type Clothing, type ClothOptions, type LayerOptions } from "./cloth_layer.ts";

/** A layer for scenes that three's WebGPURenderer draws. */
export function clothLayer(options: LayerOptions = {}): Promise<ClothLayer> {
  return ClothLayer.create(screenMaterial, options);
}

let common: Promise<ClothLayer> | null = null;

/**
 * Clothes a mesh, by a layer that all meshes of the page share.
 *
 * @throws InputError no WebGPU, a mesh without uv or normals, or a fabric that cannot be.
 */
export async function clothe(mesh: Mesh, fabric: Fabric, options: ClothOptions = {}): Promise<Clothing> {
  common ??= clothLayer();
  return (await common).clothe(mesh, fabric, options);
}

function screenMaterial(picture: Texture): ScreenMaterial {
  const material = new NodeMaterial();
  material.name = "cloth";
  // `screenUV` counts within the viewport already.
  material.fragmentNode = texture(picture, screenUV);
  material.side = DoubleSide;
  material.transparent = true;
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  material.toneMapped = false;
  return { material, setViewport: () => undefined };
}
