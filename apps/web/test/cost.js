// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What work costs: processor time, which others on the machine hardly change, so that a limit is judged at any load.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";

const ticksPerSecond = 100; // of Linux, for every program

/** Processor seconds of each thread that computes for the browser's pages: their workers, and those that these have started. */
async function computed(page) {
  const session = await page.context().browser().newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  const seconds = new Map();
  for (const { id } of processInfo.filter(({ type }) => type === "renderer")) {
    for (const thread of readdirSync(`/proc/${id}/task`)) {
      // "number (name) state ...": the 14th and the 15th field are the ticks of the thread and of the system for it.
      const [, name, rest] = /^\d+ \((.*)\) (.*)$/s.exec(readFileSync(`/proc/${id}/task/${thread}/stat`, "utf8"));
      const fields = rest.split(" ");
      if (name.startsWith("DedicatedWorker")) seconds.set(thread, (Number(fields[11]) + Number(fields[12])) / ticksPerSecond);
    }
  }
  return seconds;
}

/** Processor seconds of each thread that computes for the page while `work` is done, the busiest first. */
export async function costOf(page, work) {
  const before = await computed(page);
  await work();
  const after = await computed(page);
  const seconds = [...after].map(([thread, value]) => value - (before.get(thread) ?? 0));
  assert.ok(seconds.length > 0, "no thread computes");
  return seconds.sort((x, y) => y - x);
}

/** The part of the clock's time that a program which always computes gets now: 1 on an idle machine. */
export function share() {
  const [start, before] = [performance.now(), process.cpuUsage()];
  const computed = () => Object.values(process.cpuUsage(before)).reduce((sum, microseconds) => sum + microseconds) / 1000;
  while (computed() < 100);
  return Math.min(1, computed() / (performance.now() - start));
}

export function within(context, what, value, limit) {
  context.diagnostic(`${what}: ${value.toFixed(2)}, at most ${limit.toFixed(2)}`);
  assert.ok(value <= limit, what);
}
