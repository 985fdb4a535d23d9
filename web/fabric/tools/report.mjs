// Reads a JSON list of questions from standard input and writes the list of answers (see report.ts).
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const { module } = await runnerImport(fileURLToPath(new URL("report.ts", import.meta.url)), { logLevel: "error" });
const questions = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(questions.map(module.report)));
