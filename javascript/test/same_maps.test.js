// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The same maps as the program's, by all methods.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "counterpart3d";
import { bytesOf, match, run } from "./native.js";

const counterpart = await load();
const deformed = (name, ...options) => run("deform", "body.ply", name, ...options);
run("deform", "body", "body.ply", "--subdivisions", "2");
run("deform", "body", "small.ply", "--subdivisions", "1");
deformed("posed.ply", "--bend", "60", "--twist", "20", "--shuffle", "3", "--move");
deformed("remeshed.ply", "--bend", "40", "--retriangulate", "0.7", "--shuffle", "4");
deformed("warped.ply", "--warp", "0.03", "--retriangulate", "0.5", "--shuffle", "5", "--move");
deformed("cut.ply", "--bend", "30", "--cut", "0.4", "--retriangulate", "0.8", "--shuffle", "6");
deformed("holes.ply", "--twist", "30", "--holes", "4", "--shuffle", "7");
run("deform", "small.ply", "other_small.ply", "--twist", "10", "--shuffle", "8");

const pairs = [
  ["body.ply", "posed.ply", "auto"],
  ["body.ply", "posed.ply", "exact"],
  ["posed.ply", "body.ply", "frontiers"],
  ["body.ply", "remeshed.ply", "auto"],
  ["body.ply", "warped.ply", "spectral"],
  ["remeshed.ply", "posed.ply", "spectral"],
  ["cut.ply", "body.ply", "partial"],
  ["holes.ply", "body.ply", "auto"],
  ["body.ply", "warped.ply", "nearest"],
  ["small.ply", "other_small.ply", "assignment"],
];
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
