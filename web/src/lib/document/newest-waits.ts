/** One job at a time: of those that come while one is under way only the newest waits. */

interface NewestWaits<T> {
  offer(job: T): void;
  /** Forgets the one that waits. */
  drop(): void;
}

/** `run` tells of failures itself; one that throws ends only its own job. */
export function createNewestWaits<T>(run: (job: T) => Promise<void>): NewestWaits<T> {
  let busy = false;
  let waiting: { job: T } | null = null;

  async function work(job: T): Promise<void> {
    busy = true;
    await run(job).catch(() => undefined);
    busy = false;
    const next = waiting;
    waiting = null;
    if (next !== null) void work(next.job);
  }

  return {
    offer(job) {
      if (busy) waiting = { job };
      else void work(job);
    },
    drop() {
      waiting = null;
    },
  };
}
