// Builds into a scratch folder and fails when a byte differs from the committed dist/.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("..", import.meta.url));
const committed = join(root, "dist");
const fresh = mkdtempSync(join(tmpdir(), "strainsite-dist-"));

function files(folder) {
  return readdirSync(folder, { recursive: true })
    .map((name) => join(folder, name))
    .filter((path) => statSync(path).isFile())
    .map((path) => relative(folder, path))
    .sort();
}

try {
  const vite = join(root, "node_modules", "vite", "bin", "vite.js");
  const arguments_ = [vite, "build", "--logLevel", "warn", "--outDir", fresh, "--emptyOutDir"];
  execFileSync(process.execPath, arguments_, { cwd: root, stdio: "inherit" });
  const names = [...new Set([...files(committed), ...files(fresh)])].sort();
  const drifted = names.filter((name) => {
    try {
      return !readFileSync(join(committed, name)).equals(readFileSync(join(fresh, name)));
    } catch {
      return true;
    }
  });
  if (drifted.length > 0) {
    console.error(`dist/ differs from its sources: ${drifted.join(", ")}. Run "npm run build" and commit dist/.`);
    process.exitCode = 1;
  } else {
    console.log(`dist/ is what its sources build: ${names.length} files, byte for byte.`);
  }
} finally {
  rmSync(fresh, { recursive: true, force: true });
}
