import { defineConfig } from "vite";

/** The service that `npm run dev` talks to. */
const service = process.env.STRAINSITE_URL ?? "http://127.0.0.1:8080";

interface Graph {
  getModuleInfo(id: string): { importedIds: readonly string[] } | null;
}

/** Whether a module needs d3, which draws charts and maps. */
function drawn(id: string, graph: Graph): boolean {
  const found = new Set([id]);
  for (const next of found) for (const imported of graph.getModuleInfo(next)?.importedIds ?? []) found.add(imported);
  return [...found].some((module) => module.includes("/node_modules/d3-"));
}

/** Sources that several pages share. */
const SHARED = { minShareCount: 2, test: /\.(ts|tsx|js|mjs)$/ };

export default defineConfig({
  // Addresses are relative to the page: a proxy may serve it below a path.
  base: "./",
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
      // What several pages share is a few files, not a dozen small ones: what is needed before anything is shown, what other views share, and what draws their
      // charts and maps, for which neither the answer nor the form of a new study waits.
      output: {
        chunkFileNames: ({ isDynamicEntry }) => (isDynamicEntry ? "assets/views/[name]-[hash].js" : "assets/[name]-[hash].js"),
        codeSplitting: {
          groups: [
            { ...SHARED, name: "common", tags: ["$initial"] },
            { ...SHARED, debugName: "views", name: (id, graph) => (drawn(id, graph) ? null : "views") },
            { ...SHARED, name: "charts" },
          ],
        },
      },
    },
  },
  // The service answers only to its own name and lets only its own page write.
  server: { proxy: { "^/(v1|openapi.json)": { target: service, changeOrigin: true, headers: { origin: service } } } },
});
