import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

import { alias } from "../vite.shared.ts";

const source = (name: string): string => fileURLToPath(new URL(`src/${name}.ts`, import.meta.url));

// The module for pages without a bundler, with shaders in it and three.js left outside.
export default defineConfig({
  resolve: { alias },
  build: {
    lib: {
      entry: {
        "loomlight-web": source("index"),
        "loomlight-web-three": source("three/webgl"),
        "loomlight-web-three-webgpu": source("three/webgpu"),
      },
      formats: ["es"],
    },
    outDir: "dist",
    target: "es2022",
    rollupOptions: { external: [/^three/] },
    chunkSizeWarningLimit: 3000,
  },
});
