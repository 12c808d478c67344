import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

/** The service that `npm run dev` talks to. */
const service = process.env["STRAINSITE_URL"] ?? "http://127.0.0.1:8080";

const MAIN = fileURLToPath(new URL("src/main.tsx", import.meta.url));

/** Modules that the dashboard imports before it shows anything. */
const first = new Set<string>();

/** The file of a module that several others share. */
function sharedFile(id: string, graph: { getModuleInfo(id: string): { importedIds: readonly string[] } | null }): string {
  const open = first.size === 0 ? [MAIN] : [];
  for (let next = open.pop(); next !== undefined; next = open.pop()) {
    if (first.has(next)) continue;
    first.add(next);
    open.push(...(graph.getModuleInfo(next)?.importedIds ?? []));
  }
  return first.has(id) ? "common" : "views";
}

export default defineConfig({
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    // The policy is default-src 'self': nothing may become a data: address, and no polyfill script is wanted.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // three is one of 530 kB, 130 packed, loaded by the tire alone.
    chunkSizeWarningLimit: 600,
    // The dashboard, and the page of the operations.
    rolldownOptions: {
      input: ["index.html", "docs.html"],
      // What several views share is one file, not a dozen small ones; what every view needs is another, so that the answer doesn't wait for the tire's code.
      output: { chunkFileNames: "assets/views/[name]-[hash].js", codeSplitting: { groups: [{ debugName: "shared", name: sharedFile, minShareCount: 2, test: /\.(ts|tsx|js|mjs)$/ }] } },
    },
  },
  // The service answers only to its own name and lets only its own page write.
  server: { proxy: { "^/(v1|openapi.json)": { target: service, changeOrigin: true, headers: { origin: service } } } },
});
