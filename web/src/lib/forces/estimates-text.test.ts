import assert from "node:assert/strict";
import { test } from "node:test";
import { leftOutText, readEstimates } from "./estimates-text.ts";

test("estimates are read with every force, and rows outside what was learnt are counted", () => {
  const found = readEstimates(
    'time_s,fx_n,fx_n_low,fx_n_high,"f, z","f, z_low","f, z_high",outside\n0.0,1.5,1.0,2.0,-3.0,-4.0,-2.0,0\n0.1,1.6,1.1,2.1,-3e-1,-4.0,-2.0,1\n',
  );
  assert.deepEqual(
    found?.forces.map(({ force }) => force),
    ["fx_n", "f, z"],
  );
  assert.deepEqual(found?.forces[1]?.rows[1], { time_s: 0.1, truth_n: null, estimate_n: -0.3, low_n: -4, high_n: -2 });
  assert.deepEqual([found?.rows, found?.outside], [2, 1]);
});

test("anything else is no table of estimates", () => {
  for (const text of ["", "time_s,outside,x\n", "<html>", "time_s,f,f_low,f_high,outside\n0,1,2\n", "time_s,f,f_low,f_high,outside\n0,1,2,x,0\n"]) {
    assert.equal(readEstimates(text), null, text);
  }
  assert.equal(readEstimates("time_s,f,f_low,f_high,outside\n")?.rows, 0);
});

test("rows that were left out are written with all digits under the names of their files", () => {
  const left = { force: "fz_n", run: [0, 1], time_s: [0, 0.1], truth_n: [1, 2], estimate_n: [1.0000000000000002, 2], low_n: [0, 1], high_n: [2, 3] };
  assert.equal(
    leftOutText([left], ["a,b.csv", "c.csv"]),
    'force,recording,time_s,truth_n,estimate_n,low_n,high_n\r\nfz_n,"a,b.csv",0,1,1.0000000000000002,0,2\r\nfz_n,c.csv,0.1,2,2,1,3\r\n',
  );
});
