import { writeFileSync } from "node:fs";

import { build, defineConfig, type Plugin, type ResolvedConfig } from "vite";

import { alias, CLIENT } from "../vite.shared.ts";

/**
 * Writes the page once more as one file, `widget.html`: a widget of a notebook hands it over as a text, and asks
 * Python for everything else.
 */
function asOneFile(): Plugin {
  let config: ResolvedConfig;
  return {
    name: "as-one-file",
    apply: "build",
    configResolved: (resolved) => void (config = resolved),
    async closeBundle() {
      const built = await build({
        configFile: false,
        root: config.root,
        logLevel: "warn",
        resolve: { alias },
        build: {
          ...{ write: false, copyPublicDir: false, target: "es2022", modulePreload: false, chunkSizeWarningLimit: 3000 },
          ...{ assetsInlineLimit: Infinity, rolldownOptions: { output: { codeSplitting: false } } },
        },
      });
      const { output } = (Array.isArray(built) ? built[0]! : built) as Extract<typeof built, { output: unknown }>;
      const text = (suffix: string): string => {
        const file = output.find(({ fileName }) => fileName.endsWith(suffix))!;
        return file.type === "chunk" ? file.code : String(file.source);
      };
      const inlined = text(".html")
        .replace(/<link rel="icon"[^>]*>/, "")
        .replace('content="api/session"', 'content="frame"')
        .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${text(".css")}</style>`)
        .replace(/<script type="module"[^>]*><\/script>/, "")
        .replace("</body>", () => `<script type="module">${text(".js").replaceAll("</script", "<\\/script")}</script></body>`);
      writeFileSync(`${config.build.outDir}/widget.html`, inlined);
    },
  };
}

export default defineConfig({
  base: "./", // the page also works from any folder of a web server
  resolve: { alias },
  plugins: [asOneFile()],
  build: { outDir: CLIENT, emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 3000 },
  server: { fs: { allow: ["../.."] }, proxy: { "/api": "http://127.0.0.1:8377" } },
});
