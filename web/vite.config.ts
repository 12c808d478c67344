import { defineConfig } from "vite";

/** The service that `npm run dev` talks to. */
const service = process.env["STRAINSITE_URL"] ?? "http://127.0.0.1:8080";

export default defineConfig({
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    // The policy is default-src 'self': nothing may become a data: address, and no polyfill script is wanted.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  // The service answers only to its own name and lets only its own page write.
  server: { proxy: { "/v1": { target: service, changeOrigin: true, headers: { origin: service } } } },
});
