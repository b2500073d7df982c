// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Files in and out of the built page.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import { bytesOf, folder as native, run } from "../../../javascript/test/native.js";
import { writeCharacter } from "./character.js";
import { folder, write, writePair } from "./meshes.js";
import { canMatch, give, matched, picture, saved, text, visits } from "./visit.js";

const start = visits();

/** Drops files on the source. */
async function drop(page, files) {
  const contents = files.map((file) => ({ name: basename(file), base64: readFileSync(file).toString("base64") }));
  await page.evaluate((contents) => {
    const dataTransfer = new DataTransfer();
    for (const { name, base64 } of contents)
      dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    const event = new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true });
    document.getElementById("source-drop").dispatchEvent(event);
  }, contents);
}

/** The same mesh as a glTF that names its buffer. */
function writeGltf(name) {
  const gltf = JSON.parse(readFileSync(join(native, name)).toString());
  const [, base64] = gltf.buffers[0].uri.split("base64,");
  gltf.buffers[0].uri = "buffer.bin";
  return [write(name, JSON.stringify(gltf)), write("buffer.bin", Buffer.from(base64, "base64"))];
}

run("deform", "body", "a.obj", "--subdivisions", "1");
run("deform", "a.obj", "b.ply", "--bend", "40", "--shuffle", "2", "--truth", "truth.txt");
const truth = readFileSync(join(native, "truth.txt")).toString();

for (const ending of ["obj", "ply", "off", "stl", "glb", "vtk", "vtp"]) {
  test(`an ${ending} file and a PLY are dropped and matched`, async () => {
    run("convert", "a.obj", `dropped.${ending}`);
    const { page, end } = await start();
    await drop(page, [join(native, `dropped.${ending}`), join(native, "b.ply")]);
    await canMatch(page);
    await matched(page);
    const map = (await saved(page, "save-map")).bytes.toString();
    // STL has its own order; glTF splits nothing of a mesh without normals.
    if (ending !== "stl") assert.equal(map, truth);
    assert.match(await text(page, "summary"), /Matched 1,138 of 1,138 vertices by exact/);
    await end();
  });
}

test("a glTF is dropped with the buffer that it names", async () => {
  run("convert", "a.obj", "dropped.gltf");
  const { page, end } = await start();
  await drop(page, [...writeGltf("dropped.gltf"), join(native, "b.ply")]);
  await canMatch(page);
  await matched(page);
  assert.equal((await saved(page, "save-map")).bytes.toString(), truth);
  await end();
});

test("the map and the reordered mesh are downloaded, as the program writes them", async () => {
  const { source, target, truth } = writePair(70, 32);
  const { page, end } = await start();
  await give(page, source, target);
  await matched(page);
  const map = await saved(page, "save-map");
  assert.equal(map.name, "map.txt");
  assert.deepEqual(Uint32Array.from(map.bytes.toString().trim().split("\n"), Number), truth);
  run("reorder", source, target, "-o", "reordered.ply");
  assert.ok((await saved(page, "save-reordered")).bytes.equals(readFileSync(join(native, "reordered.ply"))));
  await end();
});

test("a GLB with everything transferred is downloaded, as the program writes it", async () => {
  const { source, target } = writePair(24, 16, "bare");
  const character = writeCharacter("character.gltf", source);
  const { page, end } = await start();
  await give(page, character, target);
  await matched(page);
  writeFileSync(join(native, "map.txt"), (await saved(page, "save-map")).bytes);
  run("transfer", character, target, "--map", "map.txt", "-o", "transferred.glb");
  const { name, bytes } = await saved(page, "save-glb");
  assert.equal(name, "transferred.glb");
  for (const attribute of ["TEXCOORD_0", "COLOR_0", "JOINTS_0", "WEIGHTS_0", "targetNames", "image/png"])
    assert.ok(bytes.includes(attribute), attribute);
  assert.ok(bytes.equals(bytesOf("transferred.glb")));
  await end();
});

test("an object of a file is chosen", async () => {
  const { source, target } = writePair(20, 12, "small");
  const square = (x) => `v ${x} 0 0\nv ${x + 1} 0 0\nv ${x + 1} 1 0\nv ${x} 1 0\nf -4 -3 -2\nf -4 -2 -1\n`;
  const file = write("scene.obj", `o left\n${square(0)}o right\n${square(3)}${square(5)}`);
  const { page, end } = await start();
  await page.setInputFiles("#source-file", file);
  await page.waitForFunction(() => /12 vertices/.test(document.getElementById("source-name").textContent));
  const offered = await page.locator("#source-object option").allInnerTexts();
  assert.deepEqual(offered, ["all 2 objects", "left: 2 triangles", "right: 4 triangles"]);
  await picture(page, "objects");
  await page.selectOption("#source-object", "right");
  await page.waitForFunction(() => /8 vertices/.test(document.getElementById("source-name").textContent));
  await page.setInputFiles("#source-file", [source, target]);
  await page.waitForFunction(() => /240 vertices/.test(document.getElementById("source-name").textContent));
  assert.ok(await page.isHidden("#source-object"));
  await end();
});

test("broken files are refused with the place and the reason, and others can follow", async () => {
  const { source, target } = writePair(20, 12, "small");
  const { page, end } = await start();
  const refused = async (file, sentence) => {
    await page.setInputFiles("#source-file", file);
    await page.waitForSelector("#error:not([hidden])");
    assert.match(await text(page, "error"), sentence);
    assert.ok(await page.isDisabled("#match"));
  };
  await refused(write("broken.obj", "v 0 0 0\nv 1 0 zero\n"), /broken\.obj:2: .*zero/);
  await picture(page, "broken");
  const named = { asset: { version: "2.0" }, buffers: [{ uri: "https://example.org/mesh.bin", byteLength: 4 }] };
  await refused(write("named.gltf", JSON.stringify(named)), /example\.org/);
  named.buffers[0].uri = "../../etc/passwd";
  await refused(write("named.gltf", JSON.stringify(named)), /leads out of the folder/);
  named.buffers[0].uri = "missing.bin";
  await refused(write("named.gltf", JSON.stringify(named)), /missing\.bin/);
  await refused(write("notes.txt", "hello"), /must end in/);
  await give(page, source, target);
  await matched(page);
  await end();
});

test("a file of 200 MB is read, and the page lives on", async (context) => {
  const { source } = writePair(20, 12, "small");
  const large = writePair(2600, 1900, "huge").source;
  assert.ok(readFileSync(large).length > 200e6, folder);
  const { page, end } = await start();
  await page.setInputFiles("#source-file", large);
  await page.waitForFunction(
    () => /vertices/.test(document.getElementById("source-name").textContent) || !document.getElementById("error").hidden,
  );
  context.diagnostic(await text(page, "source-name"));
  assert.match(await text(page, "source-name"), /4,940,000 vertices/);
  await page.setInputFiles("#source-file", source);
  await page.waitForFunction(() => /240 vertices/.test(document.getElementById("source-name").textContent));
  await end();
});
