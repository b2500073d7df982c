// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// How long the built page takes, in processor time of its threads: the clock's depends on who else uses the machine.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { cost, folder as native, run } from "../../../javascript/test/native.js";
import { costOf, share, within } from "./cost.js";
import { writePair } from "./meshes.js";
import { give, resultOf, secondsOf, text, visits } from "./visit.js";

const start = visits();
const sum = (values) => values.reduce((total, value) => total + value, 0);

/** Matches: seconds by the clock, and of each thread, the busiest first. */
async function measured(page) {
  const threads = await costOf(page, async () => {
    await page.click("#match");
    await page.waitForSelector("#result:not([hidden]), #error:not([hidden])");
  });
  await resultOf(page);
  return { clock: await secondsOf(page), threads };
}

const words = ({ clock, threads }) =>
  `${clock.toFixed(2)} s by the clock, threads ${threads.map((seconds) => seconds.toFixed(2)).join(", ")} s`;

test("the page stands within a second", async (context) => {
  const seconds = [];
  for (let i = 0; i < 3; i++) {
    const before = share();
    const { milliseconds, end } = await start();
    seconds.push(((milliseconds / 1000) * (before + share())) / 2);
    context.diagnostic(`${(milliseconds / 1000).toFixed(2)} s by the clock`);
    await end();
  }
  within(context, "seconds until it can be used, of the machine's time that it could have", Math.min(...seconds), 1);
});

for (const serviceWorkers of ["block", "allow"]) {
  test(`an exact pair of 100 000 vertices, ${serviceWorkers === "allow" ? "with" : "without"} threads`, async (context) => {
    const { source, target } = writePair(400, 250, "large");
    const { page, end } = await start({ serviceWorkers });
    await give(page, source, target);
    const found = [];
    for (let i = 0; i < 3; i++) found.push(await measured(page));
    for (const each of found) context.diagnostic(words(each));
    assert.match(await text(page, "summary"), /Matched 100,000 of 100,000 vertices by exact/);
    within(context, "seconds of the busiest thread", Math.min(...found.map(({ threads }) => threads[0])), 2);
    await end();
  });
}

test("a near-isometric pair of 5000 vertices costs at most three times as much as in the program", async (context) => {
  const [a, b] = ["a.ply", "b.ply"];
  run("deform", "body", a, "--retriangulate", "0.275");
  run("deform", "body", b, "--bend", "60", "--retriangulate", "0.275", "--seed", "2", "--shuffle", "3");
  const alone = await start({ serviceWorkers: "block" });
  const together = await start();
  for (const { page } of [alone, together]) await give(page, join(native, a), join(native, b));
  const ratios = [];
  const shares = [];
  for (let i = 0; i < 3; i++) {
    const program = cost("match", a, b, "-o", "map.txt", "--threads", "1");
    const [one, all] = [await measured(alone.page), await measured(together.page)];
    ratios.push(sum(one.threads) / program);
    shares.push(sum(all.threads.slice(1)) / sum(all.threads));
    context.diagnostic(`program ${program.toFixed(2)} s; page: ${words(one)}; with threads: ${words(all)}`);
    context.diagnostic(`${(one.clock / all.clock).toFixed(2)} times as fast with threads`);
  }
  context.diagnostic(await text(alone.page, "summary"));
  within(context, "times the program's cost", Math.min(...ratios), 3);
  assert.ok(Math.max(...shares) > 0.2, `other threads than the busiest take ${shares}`);
  for (const { end } of [alone, together]) await end();
});
