import assert from "node:assert/strict";
import { test } from "node:test";
import { setImmediate } from "node:timers/promises";
import { createNewestWaits } from "./newest-waits.ts";

/** Jobs that end when they are told to. */
function traced() {
  const begun: number[] = [];
  const ends: ((error?: Error) => void)[] = [];
  const jobs = createNewestWaits<number>((job) => {
    begun.push(job);
    return new Promise((resolve, reject) => ends.push((error) => (error === undefined ? resolve() : reject(error))));
  });
  return { jobs, begun, end: (index: number, error?: Error) => ends[index]?.(error) };
}

test("of all jobs that come while one runs only the newest is done after it", async () => {
  const { jobs, begun, end } = traced();
  [1, 2, 3, 4].forEach(jobs.offer);
  assert.deepEqual(begun, [1]);
  end(0);
  await setImmediate();
  assert.deepEqual(begun, [1, 4]);
  end(1);
  await setImmediate();
  assert.deepEqual(begun, [1, 4]);
  jobs.offer(5);
  assert.deepEqual(begun, [1, 4, 5]);
});

test("a job that fails doesn't hold up the next, and one that waits can be dropped", async () => {
  const { jobs, begun, end } = traced();
  jobs.offer(1);
  jobs.offer(2);
  end(0, new Error("failed"));
  await setImmediate();
  assert.deepEqual(begun, [1, 2]);
  jobs.offer(3);
  jobs.drop();
  end(1);
  await setImmediate();
  assert.deepEqual(begun, [1, 2]);
});
