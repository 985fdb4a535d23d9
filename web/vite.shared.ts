/** Places that every build of `web/` shares: generated shaders are `@shaders`, and our own modules are their sources. */
import { fileURLToPath } from "node:url";

export const PACKAGE = fileURLToPath(new URL("../src/loomlight/", import.meta.url));
export const SHADERS = `${PACKAGE}realtime/shaders`;
export const CLIENT = `${PACKAGE}viewer/static`;
const source = (name: string): string => fileURLToPath(new URL(`loomlight-web/src/${name}.ts`, import.meta.url));
// The first that begins an import is taken, so the longest come first.
export const alias = {
  "@shaders": SHADERS,
  "loomlight-fabric": fileURLToPath(new URL("fabric/src/index.ts", import.meta.url)),
  "loomlight-web/three-webgpu": source("three/webgpu"),
  "loomlight-web/three": source("three/webgl"),
  // What a fabric looks like, without the shaders that draw it.
  "loomlight-web/look": source("fabric/look"),
  "loomlight-web": source("index"),
};
