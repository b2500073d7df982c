// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// How long the built page takes.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { bytesOf, folder as native, run } from "../../../javascript/test/native.js";
import { writePair } from "./meshes.js";
import { give, matched, secondsOf, text, visits, within } from "./visit.js";

const start = visits();

/** The best of three: others may use the machine. */
async function bestOfThree(page) {
  const seconds = [];
  for (let i = 0; i < 3; i++) {
    await matched(page);
    seconds.push(await secondsOf(page));
  }
  return Math.min(...seconds);
}

test("an exact pair of 100 000 vertices", async (context) => {
  const { source, target } = writePair(400, 250, "large");
  const { page, end } = await start();
  await give(page, source, target);
  const seconds = await bestOfThree(page);
  assert.match(await text(page, "summary"), /Matched 100,000 of 100,000 vertices by exact/);
  within(context, "seconds", seconds, 2);
  await end();
});

test("a near-isometric pair of 5000 vertices takes at most three times as long as a thread of the program", async (context) => {
  const [a, b] = ["a.ply", "b.ply"];
  run("deform", "body", a, "--retriangulate", "0.275");
  run("deform", "body", b, "--bend", "60", "--retriangulate", "0.275", "--seed", "2", "--shuffle", "3");
  const { page, end } = await start();
  await give(page, join(native, a), join(native, b));
  const ratios = [];
  for (let i = 0; i < 2; i++) {
    run("match", a, b, "-o", "map.txt", "--threads", "1", "--report", "report.json");
    const seconds = JSON.parse(bytesOf("report.json").toString()).seconds.match;
    await matched(page);
    ratios.push((await secondsOf(page)) / seconds);
    context.diagnostic(`program ${seconds.toFixed(2)} s, page ${(await secondsOf(page)).toFixed(2)} s`);
  }
  context.diagnostic(await text(page, "summary"));
  within(context, "times as long", Math.min(...ratios), 3);
  await end();
});
