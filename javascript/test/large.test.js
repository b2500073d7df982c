// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What large meshes take.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "counterpart3d";
import { bytesOf, run } from "./native.js";

test("two meshes of a million vertices are matched exactly within 2 GB", async (context) => {
  const counterpart = await load();
  run("deform", "body", "large.ply", "--subdivisions", "6");
  run("deform", "large.ply", "large_posed.ply", "--bend", "50", "--shuffle", "3", "--truth", "large_truth.npy");
  const start = performance.now();
  const [a, b] = ["large.ply", "large_posed.ply"].map((name) => counterpart.readMesh(name, bytesOf(name)));
  const read = performance.now();
  assert.ok(a.nVertices >= 1e6, `${a.nVertices} vertices`);
  const { targetFromSource, method } = counterpart.match(a, b);
  const matched = performance.now();
  context.diagnostic(
    `${a.nVertices} vertices: read in ${((read - start) / 1000).toFixed(1)} s, matched in ` +
      `${((matched - read) / 1000).toFixed(1)} s, ${(counterpart.memory / 2 ** 30).toFixed(2)} GB of memory`,
  );
  assert.equal(method, "exact");
  const truth = bytesOf("large_truth.npy");
  const header = truth.length - 4 * a.nVertices;
  const nWrong = targetFromSource.filter((image, v) => image !== truth.readInt32LE(header + 4 * v)).length;
  assert.equal(nWrong, 0);
  assert.ok(counterpart.memory <= 2 * 2 ** 30, `${counterpart.memory} bytes`);
});
