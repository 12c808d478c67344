// Starts the real binary on a free port with a database of its own, and ends it as a user would.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const binary = process.env.STRAINSITE_BIN ?? join(root, "target", "release", "strainsite");
const READY_MS = 30_000;
const STOP_MS = 30_000;

/** With further arguments of `serve`, if any. */
export async function startService(...more) {
  const folder = mkdtempSync(join(tmpdir(), "strainsite-browser-"));
  const begin = (address) => begun(address, join(folder, "studies.db"), more);
  let running = await begin("127.0.0.1:0");
  return {
    url: running.url,
    log: () => running.log(),
    printed: () => running.printed(),
    /** Ends the service as a power cut would. */
    async kill() {
      running.child.kill("SIGKILL");
      await running.exited;
    },
    /** Begins again where it was, on the same database. */
    async restart() {
      running = await begin(new URL(running.url).host);
    },
    /** Interrupts the service and gives its exit code. */
    async stop() {
      const { child, exited } = running;
      child.kill("SIGINT");
      const timer = setTimeout(() => child.kill("SIGKILL"), STOP_MS);
      const end = await exited;
      clearTimeout(timer);
      rmSync(folder, { recursive: true, force: true });
      return end;
    },
  };
}

async function begun(address, database, more) {
  const child = spawn(binary, ["serve", "--addr", address, "--db", database, ...more], { cwd: root, stdio: ["ignore", "pipe", "pipe"] });
  const texts = { log: "", printed: "" };
  child.stdout.on("data", (chunk) => (texts.printed += chunk));
  child.stderr.on("data", (chunk) => (texts.log += chunk));
  const exited = new Promise((resolve) => child.on("close", (code, signal) => resolve({ code, signal })));
  const url = await readUrl(child, exited, () => texts.log);
  return { child, exited, url, log: () => texts.log, printed: () => texts.printed };
}

function readUrl(child, exited, log) {
  return new Promise((resolve, reject) => {
    let text = "";
    const fail = (why) => reject(new Error(`${why}; stdout: ${text}; stderr: ${log()}`));
    const timer = setTimeout(() => {
      child.kill("SIGKILL");
      fail("the service printed no address");
    }, READY_MS);
    child.on("error", (error) => fail(`${binary} can't be started: ${error.message}`));
    exited.then(({ code }) => fail(`the service ended with code ${code}`));
    child.stdout.on("data", (chunk) => {
      text += chunk;
      const url = /listening on (http:\/\/[^\s/]+)/.exec(text)?.[1];
      if (url === undefined) return;
      clearTimeout(timer);
      resolve(url);
    });
  });
}
