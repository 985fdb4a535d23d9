/** Woven cloth on WebGPU: bakes fabrics in the page and renders meshes of cloth. */
export type { Openness } from "./fabric/between_yarns.ts";
export { lookOf, type Appearance, type ClothLayout, type FamilyLayout, type Look } from "./fabric/look.ts";
export { NO_ADAPTER, NO_WEBGPU } from "./gpu/device.ts";
export type { TableCache } from "./gpu/table_cache.ts";
export { BUDGET, type Budget } from "./pace.ts";
export { ClothRenderer, type RendererOptions } from "./renderer.ts";
export { FIELD_OF_VIEW } from "./scene/camera.ts";
export { rectangle } from "./scene/mesh.ts";
export * from "./scene/orbit.ts";
export type * from "./types.ts";
export { fabricOf, type Fabric } from "./fabric_source.ts";
