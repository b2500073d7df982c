// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// GLB files that the program wrote, in three.js: skin and morph targets move the vertices.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch } from "./browser.js";
import { writeCharacter } from "./character.js";
import { program } from "./pair.js";

const folder = mkdtempSync(join(tmpdir(), "counterpart_gltf_"));
const three = fileURLToPath(new URL("../node_modules/three/", import.meta.url));
const origin = "http://counterpart.test/";
const html = `<!doctype html><script type="importmap">{"imports": {"three": "${origin}three/build/three.module.js",
  "three/addons/": "${origin}three/examples/jsm/"}}</script>
<script type="module">
  import * as THREE from "three";
  import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
  window.load = async (name) => {
    const gltf = await new GLTFLoader().loadAsync(name);
    gltf.scene.updateMatrixWorld(true);
    let mesh;
    gltf.scene.traverse((object) => { if (object.isMesh) mesh = object; });
    const positions = () => Array.from({ length: mesh.geometry.attributes.position.count }, (_, v) =>
      mesh.getVertexPosition(v, new THREE.Vector3()).toArray());
    window.character = { THREE, gltf, mesh, positions };
  };
  window.ready = true;
</script>`;

let browser;
let page;
const complaints = [];
before(async () => {
  const run = (...args) => execFileSync(program, [...args, "-q"], { cwd: folder });
  writeCharacter(join(folder, "bar.glb"));
  run("convert", "bar.glb", "copy.glb");
  run("deform", "bar.glb", "order.obj", "--shuffle", "5");
  run("reorder", "order.obj", "bar.glb", "-o", "reordered.glb");
  run("deform", "bar.glb", "bent.obj", "--bend", "30");
  run("morph", "bar.glb", "bent.obj", "-n", "2", "-o", "morph.glb");
  browser = await launch();
  page = await (await browser.newContext()).newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.route(`${origin}**`, (route) => {
    const path = new URL(route.request().url()).pathname.slice(1);
    if (path === "") return route.fulfill({ contentType: "text/html", body: html });
    if (path === "favicon.ico") return route.fulfill({ status: 204 });
    const file = path.startsWith("three/") ? join(three, path.slice("three/".length)) : join(folder, path);
    const contentType = file.endsWith(".js") ? "text/javascript" : "model/gltf-binary";
    return route.fulfill({ contentType, body: readFileSync(file) });
  });
  await page.goto(origin);
  await page.waitForFunction(() => window.ready === true);
});
after(() => browser?.close());

const movement = (a, b) => Math.max(...a.map((p, v) => Math.hypot(p[0] - b[v][0], p[1] - b[v][1], p[2] - b[v][2])));

/** Positions at rest, at each morph target alone, and with the elbow bent. */
const positions = (name) =>
  page.evaluate(async (name) => {
    await window.load(name);
    const { mesh, gltf, positions } = window.character;
    const rest = positions();
    const morphed = mesh.morphTargetInfluences.map((_, i) => {
      mesh.morphTargetInfluences.fill(0);
      mesh.morphTargetInfluences[i] = 1;
      return positions();
    });
    mesh.morphTargetInfluences.fill(0);
    let bent = rest;
    if (mesh.isSkinnedMesh) {
      mesh.skeleton.bones[1].rotation.z = Math.PI / 2;
      gltf.scene.updateMatrixWorld(true);
      bent = positions();
    }
    return {
      rest, morphed, bent,
      skinned: mesh.isSkinnedMesh === true,
      names: Object.keys(mesh.morphTargetDictionary ?? {}),
      bones: mesh.skeleton?.bones.map((bone) => bone.name),
      material: mesh.material.name,
      textured: mesh.material.map?.image?.width > 0,
    };
  }, name);

/** Equal up to order: the sorted rows, rounded. */
const sorted = (rows) => rows.map((row) => row.map((x) => (Math.round(x * 1e5) / 1e5 + 0).toFixed(5)).join(" ")).sort();

test("a character that was read and written moves as before", async () => {
  const before = await positions("bar.glb");
  assert.deepEqual(await positions("copy.glb"), before);
});

test("a reordered character has its skin, its three morph targets and its texture", async () => {
  const before = await positions("bar.glb");
  const now = await positions("reordered.glb");
  assert.ok(now.skinned);
  assert.deepEqual(now.bones, ["root", "elbow"]);
  assert.deepEqual(now.names, ["wide", "tall", "lean"]);
  assert.equal(now.material, "skin");
  assert.ok(now.textured);
  assert.notDeepEqual(now.rest, before.rest, "the order is another");
  assert.deepEqual(sorted(now.rest), sorted(before.rest));
  assert.ok(movement(now.rest, now.bent) > 0.3, "the skin moves vertices");
  assert.deepEqual(sorted(now.bent), sorted(before.bent));
  now.morphed.forEach((morphed, i) => {
    assert.ok(movement(now.rest, morphed) > 0.09, `morph target ${i} moves vertices`);
    assert.deepEqual(sorted(morphed), sorted(before.morphed[i]));
  });
});

test("the frames of a morph are morph targets", async () => {
  const now = await positions("morph.glb");
  assert.deepEqual(now.names, ["frame_0001", "frame_0002", "frame_0003"]);
  const steps = now.morphed.map((morphed) => movement(now.rest, morphed));
  assert.ok(steps[0] > 0.01 && steps[1] > steps[0] && steps[2] > steps[1], `${steps}`);
  // 24 frames per second: halfway between the second and the third morph target.
  const played = await page.evaluate(() => {
    const { THREE, gltf, mesh } = window.character;
    const clip = gltf.animations.find(({ name }) => name === "morph");
    const mixer = new THREE.AnimationMixer(gltf.scene);
    mixer.clipAction(clip).play();
    mixer.setTime(2.5 / 24);
    return { seconds: clip.duration, weights: mesh.morphTargetInfluences };
  });
  assert.ok(Math.abs(played.seconds - 3 / 24) < 1e-6);
  assert.deepEqual(played.weights.map((w) => Math.round(1e4 * w) / 1e4), [0, 0.5, 0.5]);
  assert.deepEqual(complaints, []);
});
