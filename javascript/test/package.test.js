// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The functions of the package, on the thread that calls them.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Canceled, InvalidInput, IoError, load } from "counterpart3d";
import { bytesOf, folder, refusal, run } from "./native.js";

const counterpart = await load();
run("deform", "body", "a.ply", "--subdivisions", "1");
run("deform", "a.ply", "b.ply", "--bend", "60", "--shuffle", "3", "--truth", "truth.txt");
const truth = Int32Array.from(bytesOf("truth.txt").toString().trim().split("\n"), Number);
const a = counterpart.readMesh("a.ply", bytesOf("a.ply"));
const b = counterpart.readMesh("b.ply", bytesOf("b.ply"));

test("a renumbered pose is matched, by file and by arrays", () => {
  const result = counterpart.match(a, b);
  assert.deepEqual(result.targetFromSource, truth);
  assert.equal(result.method, "exact");
  assert.equal(result.verdict, "use");
  assert.ok(result.isSameConnectivity);
  const arrays = counterpart.match(
    { vertices: a.vertices, triangles: a.triangles },
    { vertices: [...b.vertices], triangles: [...b.triangles] },
  );
  assert.deepEqual(arrays.targetFromSource, truth);
});

test("reorder gives the second shape in the first order", () => {
  const mesh = counterpart.reorder(a, b);
  assert.deepEqual(mesh.triangles, a.triangles);
  for (let v = 0; v < truth.length; v++)
    assert.deepEqual(mesh.vertices.slice(3 * v, 3 * v + 3), b.vertices.slice(3 * truth[v], 3 * truth[v] + 3));
});

test("what is written is read back, and is what the program writes", () => {
  for (const ending of ["obj", "off", "ply", "stl", "glb", "vtk"]) {
    const bytes = counterpart.writeMesh(a, `mesh.${ending}`);
    run("convert", "a.ply", `mesh.${ending}`);
    assert.ok(Buffer.from(bytes).equals(bytesOf(`mesh.${ending}`)), ending);
    const again = counterpart.readMesh(`mesh.${ending}`, bytes);
    assert.equal(again.nTriangles, a.nTriangles, ending);
  }
});

test("colors are transferred", () => {
  const red = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
    "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n" +
    "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n0 0 1 255 0 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const source = counterpart.readMesh("red.ply", Buffer.from(red));
  const target = counterpart.makeMesh([0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1], source.triangles);
  const { mesh, attributes } = counterpart.transfer(source, target, Int32Array.of(0, 1, 2, 3));
  assert.deepEqual(mesh.attributes, ["colors"]);
  assert.equal(attributes[0].nTransferred, 4);
});

test("a map is measured against the true one", () => {
  const perfect = counterpart.evaluate(a, b, truth, truth);
  assert.equal(perfect.nExact, truth.length);
  assert.equal(perfect.meanError, 0);
  const worse = truth.slice();
  [worse[0], worse[1]] = [worse[1], worse[0]];
  const report = counterpart.evaluate(a, b, worse, truth);
  assert.equal(report.nExact, truth.length - 2);
  assert.ok(report.meanError > 0);
});

test("progress is told, never decreases, and cancels", () => {
  const told = [];
  const [body, remeshed] = counterpart.example("remeshed");
  assert.throws(
    () => counterpart.match(body, remeshed, { onProgress: (fraction) => told.push(fraction) < 5 }),
    Canceled,
  );
  assert.equal(told.length, 5);
  assert.deepEqual(told, told.toSorted((x, y) => x - y));
  const thrown = new RangeError("from the callback");
  assert.throws(() => counterpart.match(a, b, { onProgress: () => { throw thrown; } }), (error) => error === thrown);
});

test("errors are exceptions with the program's sentences", () => {
  const broken = {
    "bad.obj": "v 0 0 0\nv 1 0 x\n",
    "face.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
    "cut.ply": "ply\nformat",
    "a.xyz": "1 2 3",
  };
  for (const [name, text] of Object.entries(broken)) {
    writeFileSync(join(folder, name), text);
    assert.throws(
      () => counterpart.readMesh(name, Buffer.from(text)),
      (error) => error instanceof IoError && refusal("inspect", name).includes(error.message),
      name,
    );
  }
  assert.throws(() => counterpart.match(a, b, { method: "best" }), InvalidInput);
  assert.throws(() => counterpart.match(a, b, { methods: "exact" }), /no option 'methods'/);
  assert.throws(() => counterpart.match(a, b, { landmarks: [[0, 1e6]], method: "spectral" }), InvalidInput);
  assert.throws(() => counterpart.makeMesh([0, 0, 0], [0, 1, 2]), InvalidInput);
  assert.throws(() => counterpart.evaluate(a, b, truth.slice(1), truth), InvalidInput);
});

test("one object of a file is read alone", () => {
  const tetrahedron = (name, x) =>
    `o ${name}\nv ${x} 0 0\nv ${x + 1} 0 0\nv ${x} 1 0\nv ${x} 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n`;
  const bytes = () => Buffer.from(tetrahedron("left", 0) + tetrahedron("right", 5));
  const both = counterpart.readMesh("two.obj", bytes());
  assert.deepEqual(both.objects, [
    { name: "left", nVertices: 4, nTriangles: 4 },
    { name: "right", nVertices: 4, nTriangles: 4 },
  ]);
  const right = counterpart.readMesh("two.obj", bytes(), { object: "right" });
  assert.deepEqual(right.vertices, both.vertices.slice(12));
  assert.deepEqual(counterpart.readMesh("two.obj", bytes(), { object: "1" }).vertices, right.vertices);
  assert.throws(() => counterpart.readMesh("two.obj", bytes(), { object: "middle" }), /middle/);
});

test("what the result says is what the program says", () => {
  run("deform", "a.ply", "part.ply", "--cut", "0.5", "--bend", "20", "--retriangulate", "0.6", "--shuffle", "2");
  const part = counterpart.readMesh("part.ply", bytesOf("part.ply"));
  for (const [source, target] of [["a.ply", "b.ply"], ["part.ply", "a.ply"]]) {
    run("match", source, target, "-o", "said.txt", "--report", "said.json", "--confidence", "said.npy");
    const said = JSON.parse(bytesOf("said.json").toString());
    const result = counterpart.match(source === "a.ply" ? a : part, target === "a.ply" ? a : b);
    assert.equal(result.verdict, said.verdict);
    assert.equal(result.verdictReason, said.verdict_reason);
    const sentences = (messages) => messages.map(({ code, severity, sentence }) => ({ code, severity, sentence }));
    assert.deepEqual(sentences(result.messages), sentences(said.messages));
    assert.deepEqual(sentences(result.causes), sentences(said.probable_causes));
    // Two libraries of mathematical functions round the last digit differently.
    const file = bytesOf("said.npy");
    const confidence = (v) => file.readDoubleLE(file.length - 8 * (result.confidence.length - v));
    const difference = Math.max(...result.confidence.map((value, v) => Math.abs(value - confidence(v))));
    assert.ok(difference < 1e-12, `${difference}`);
  }
});

test("a glTF that names other files reads those that are given, and no others", () => {
  run("convert", "a.ply", "a.gltf");
  const outside = JSON.stringify({ asset: { version: "2.0" }, buffers: [{ uri: "../../etc/passwd", byteLength: 10 }] });
  assert.throws(() => counterpart.readMesh("x.gltf", Buffer.from(outside)), /leads out of the folder/);
  const missing = outside.replace("../../etc/passwd", "other.bin");
  assert.throws(() => counterpart.readMesh("x.gltf", Buffer.from(missing)), /other\.bin/);
});
