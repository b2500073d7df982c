// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The same maps as the program's, by all methods.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "counterpart3d";
import { bytesOf, match } from "./native.js";
import { makePairs, pairs } from "./pairs.js";

const counterpart = await load();
makePairs();
for (const [source, target, method] of pairs) {
  test(`${source} to ${target} by ${method}`, (context) => {
    const expected = match(source, target, "--method", method);
    const [a, b] = [source, target].map((name) => counterpart.readMesh(name, bytesOf(name)));
    const { targetFromSource, seconds } = counterpart.match(a, b, { method });
    const nDifferent = targetFromSource.filter((image, v) => image !== expected[v]).length;
    context.diagnostic(`${expected.length} vertices; ${Object.values(seconds).reduce((sum, s) => sum + s, 0).toFixed(2)} s`);
    assert.equal(targetFromSource.length, expected.length);
    assert.equal(nDifferent, 0, `${nDifferent} of ${expected.length} vertices go elsewhere`);
  });
}
