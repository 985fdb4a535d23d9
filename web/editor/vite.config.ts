import { defineConfig } from "vite";

import { alias, CLIENT } from "../vite.shared.ts";

export default defineConfig({
  base: "./", // the page also works from any folder of a web server
  resolve: { alias },
  build: { outDir: CLIENT, emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 3000 },
  server: { fs: { allow: ["../.."] }, proxy: { "/api": "http://127.0.0.1:8377" } },
});
