import { defineConfig } from "vitest/config";

import { alias } from "./vite.shared.ts";

export default defineConfig({
  resolve: { alias },
  test: { passWithNoTests: true, include: ["*/test/**/*.test.ts"], environment: "node", pool: "threads", fileParallelism: false, testTimeout: 1_200_000 },
});
