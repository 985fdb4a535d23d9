// Reads a JSON list of questions from standard input and writes the list of answers (see camera_report.ts).
import { text } from "node:stream/consumers";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const place = (path) => fileURLToPath(new URL(path, import.meta.url));
const { module: shared } = await runnerImport(place("../../vite.shared.ts"), { logLevel: "error" });
const { module } = await runnerImport(place("camera_report.ts"), { logLevel: "error", resolve: { alias: shared.alias } });
const questions = JSON.parse(await text(process.stdin));
process.stdout.write(JSON.stringify(questions.map(module.report)));
