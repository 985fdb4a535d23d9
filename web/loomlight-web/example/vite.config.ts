import { defineConfig } from "vite";

import { alias } from "../../vite.shared.ts";

export default defineConfig({
  base: "./", // the built page works from any folder of a web server
  resolve: { alias },
  build: { outDir: "dist", target: "es2022", chunkSizeWarningLimit: 3000 },
  server: { fs: { allow: ["../../.."] } },
});
