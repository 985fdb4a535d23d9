/** Places that every build of `web/` shares: imports of generated shaders go by the alias `@shaders`. */
import { fileURLToPath } from "node:url";

export const PACKAGE = fileURLToPath(new URL("../src/loomlight/", import.meta.url));
export const SHADERS = `${PACKAGE}realtime/shaders`;
export const CLIENT = `${PACKAGE}viewer/static`;
export const alias = { "@shaders": SHADERS };
