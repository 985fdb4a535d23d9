/** Clothes meshes of scenes that three's WebGLRenderer draws: `loomlight-web/three`. */
import { CustomBlending, DoubleSide, OneFactor, OneMinusSrcAlphaFactor, ShaderMaterial, Vector4 } from "three";
import type { Mesh, Texture } from "three";

import type { Fabric } from "../fabric_source.ts";
import { ClothLayer, type Clothing, type ClothOptions, type LayerOptions, type ScreenMaterial } from "./cloth_layer.ts";

export { fabricOf, type Fabric } from "../fabric_source.ts";
export { ClothLayer, type Clothing, type ClothOptions, type LayerOptions } from "./cloth_layer.ts";

const VERTEX = "void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }";
const FRAGMENT = `
uniform sampler2D picture;
uniform vec4 viewport;
void main() {
  gl_FragColor = texture2D(picture, (gl_FragCoord.xy - viewport.xy) / viewport.zw);
  if (gl_FragColor.a == 0.0) discard;
  #include <colorspace_fragment>
}`;

/** A layer for scenes that three's WebGLRenderer draws. */
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
  const viewport = new Vector4();
  const material = new ShaderMaterial({
    name: "cloth",
    uniforms: { picture: { value: picture }, viewport: { value: viewport } },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    transparent: true,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    toneMapped: false,
  });
  return { material, setViewport: (place) => viewport.set(...(place as [number, number, number, number])) };
}
