// Reads a JSON list of questions from standard input and writes the list of answers (see report.ts).
import { text } from "node:stream/consumers";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const { module } = await runnerImport(fileURLToPath(new URL("report.ts", import.meta.url)), { logLevel: "error" });
const questions = JSON.parse(await text(process.stdin));
process.stdout.write(JSON.stringify(questions.map(module.report)));
