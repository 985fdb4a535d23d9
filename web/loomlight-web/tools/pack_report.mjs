// Packs the fabrics of a JSON file (see pack_report.ts) and writes words of their buffers to a folder.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const place = (path) => fileURLToPath(new URL(path, import.meta.url));
const [, , questions, folder] = process.argv;
const { module } = await runnerImport(place("pack_report.ts"), {
  logLevel: "error",
  resolve: {
    alias: {
      "@shaders": place("../../../src/loomlight/realtime/shaders"),
      "loomlight-fabric": place("../../fabric/src/index.ts"),
    },
  },
});
JSON.parse(readFileSync(questions, "utf8")).forEach((question, number) => {
  for (const [name, words] of Object.entries(module.report(question)))
    writeFileSync(join(folder, `${number}.${name}`), words);
});
