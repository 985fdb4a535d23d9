// Packs the fabrics of a JSON file (see pack_report.ts) and writes words of their buffers to a folder.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const shaders = fileURLToPath(new URL("../../../src/loomlight/realtime/shaders", import.meta.url));
const [, , questions, folder] = process.argv;
const { module } = await runnerImport(fileURLToPath(new URL("pack_report.ts", import.meta.url)), {
  logLevel: "error",
  resolve: { alias: { "@shaders": shaders } },
});
JSON.parse(readFileSync(questions, "utf8")).forEach((question, number) => {
  for (const [name, words] of Object.entries(module.report(question)))
    writeFileSync(join(folder, `${number}.${name}`), words);
});
