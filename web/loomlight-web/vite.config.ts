import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

import { alias } from "../vite.shared.ts";

// The module for pages without a bundler: one file, with shaders in it and three.js left outside.
export default defineConfig({
  resolve: { alias },
  build: {
    lib: {
      entry: { "loomlight-web": fileURLToPath(new URL("src/index.ts", import.meta.url)) },
      formats: ["es"],
    },
    outDir: "dist",
    target: "es2022",
    rollupOptions: { external: [/^three/] },
    chunkSizeWarningLimit: 3000,
  },
});
