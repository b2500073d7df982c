// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

// One folder that any web server serves, wherever it lies. The library is the package that scripts/wasm.sh builds.
export default defineConfig({
  base: "./",
  resolve: {
    alias: [
      { find: /^counterpart3d$/, replacement: here("../../build/wasm/package/dist/index.js") },
      { find: /^counterpart3d\/worker$/, replacement: here("../../build/wasm/package/dist/remote.js") },
      { find: /^three$/, replacement: here("node_modules/three") },
    ],
  },
  worker: { format: "es" },
  build: {
    target: "es2022",
    modulePreload: false,
    assetsInlineLimit: 0,
    rollupOptions: { input: { index: here("index.html"), viewer: here("viewer.html") } },
  },
});
