// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Uses the built page as a person would.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { folder, write, writePair } from "./meshes.js";
import { launch, open, serve } from "./site.js";

const screenshots = process.env.SCREENSHOTS ?? join(folder, "screenshots");
mkdirSync(screenshots, { recursive: true });
const picture = (page, name) => page.screenshot({ path: join(screenshots, `${name}.png`), fullPage: true });

let browser;
let site;
before(async () => {
  site = await serve();
  browser = await launch();
});
after(async () => {
  await browser?.close();
  site?.server.close();
});

const start = (options) => open(browser, site.address, options);
const patience = { timeout: 300_000 };
const text = (page, id) => page.locator(`#${id}`).innerText();

/** Waits for a result and for its view. */
async function resultOf(page) {
  await page.waitForSelector("#result:not([hidden]), #error:not([hidden])", patience);
  assert.ok(await page.isHidden("#error"), await page.locator("#error").textContent());
  const frame = await (await page.waitForSelector("#viewer:not([hidden])", patience)).contentFrame();
  await frame.waitForFunction(() => window.counterpart?.frames > 0, null, patience);
  await page.waitForSelector("#cancel", { state: "hidden", ...patience });
  return frame;
}

async function give(page, source, target) {
  await page.setInputFiles("#source-file", source);
  await page.waitForFunction(() => /vertices/.test(document.getElementById("source-name").textContent), null, patience);
  await page.setInputFiles("#target-file", target);
  await page.waitForFunction(() => !document.getElementById("match").disabled, null, patience);
}

async function saved(page, id) {
  const [download] = await Promise.all([page.waitForEvent("download", patience), page.click(`#${id}`)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test("the page stands within a second, asks only its own server, and breaks no rule of its policy", async (context) => {
  const { page, context: tab, complaints, requests, milliseconds } = await start();
  context.diagnostic(`interactive after ${milliseconds.toFixed(0)} ms`);
  assert.match(await text(page, "input"), /Drop a mesh here/);
  await page.click("[data-example=shuffled]");
  await resultOf(page);
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests.filter((url) => !url.startsWith(site.address) && !url.startsWith("data:")), []);
  const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  assert.ok(policy.startsWith("default-src 'none'") && !/unsafe-(inline|eval)/.test(policy.replace("wasm-unsafe-eval", "")));
  await tab.close();
});

for (const [kind, method, verdict] of [
  ["shuffled", "exact", /^use$/],
  ["remeshed", "spectral", /^(use|check)$/],
  ["part", "partial", /^(use|check)$/],
]) {
  test(`the example '${kind}' is matched by ${method}`, async (context) => {
    const { page, context: tab, complaints } = await start();
    await page.click(`[data-example=${kind}]`);
    await resultOf(page);
    context.diagnostic(await text(page, "summary"));
    assert.match(await text(page, "summary"), new RegExp(`by ${method} in`));
    assert.match(await text(page, "verdict"), verdict);
    await picture(page, kind);
    assert.deepEqual(complaints, []);
    await tab.close();
  });
}

test("two files are matched; the map, the reordered mesh and a GLB are downloaded", async () => {
  const { source, target, truth } = writePair(70, 32);
  const { page, context: tab } = await start();
  await page.setInputFiles("#source-file", [source, target]);
  await page.waitForFunction(() => !document.getElementById("match").disabled);
  await page.click("#match");
  await resultOf(page);
  const map = await saved(page, "save-map");
  assert.equal(map.name, "map.txt");
  assert.deepEqual(Uint32Array.from(map.bytes.toString().trim().split("\n"), Number), truth);
  assert.match((await saved(page, "save-reordered")).bytes.toString("latin1"), /^ply/);
  const glb = await saved(page, "save-glb");
  assert.equal(glb.bytes.toString("latin1", 0, 4), "glTF");
  assert.ok(glb.bytes.includes("COLOR_0"));
  await tab.close();
});

test("an exact pair of 100 000 vertices", async (context) => {
  const { source, target } = writePair(400, 250, "large");
  const { page, context: tab } = await start();
  await give(page, source, target);
  await page.click("#match");
  await resultOf(page);
  context.diagnostic(await text(page, "summary"));
  assert.match(await text(page, "summary"), /Matched 100,000 of 100,000 vertices by exact/);
  await tab.close();
});

test("an unlike pair is not said to be good", async () => {
  const { source } = writePair(60, 40, "ring");
  const cube = write("cube.obj", gridOfCube(12));
  const { page, context: tab } = await start();
  await give(page, source, cube);
  await page.click("#match");
  await resultOf(page);
  assert.notEqual(await text(page, "verdict"), "use");
  assert.notEqual(await text(page, "verdict-reason"), "");
  await picture(page, "unlike");
  await tab.close();
});

test("broken files are refused with the place and the reason, and others can follow", async () => {
  const { source, target } = writePair(20, 12, "small");
  const { page, context: tab } = await start();
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
  await refused(write("notes.txt", "hello"), /must end in/);
  await give(page, source, target);
  await page.click("#match");
  await resultOf(page);
  await tab.close();
});

test("a file of 200 MB is read or refused, and the page lives on", async (context) => {
  const { source } = writePair(20, 12, "small");
  const { page, context: tab } = await start();
  const large = writePair(2600, 1900, "huge").source;
  await page.setInputFiles("#source-file", large);
  await page.waitForFunction(
    () => /vertices/.test(document.getElementById("source-name").textContent) || !document.getElementById("error").hidden,
    null,
    patience,
  );
  context.diagnostic(await text(page, "source-name"));
  await page.setInputFiles("#source-file", source);
  await page.waitForFunction(() => /240 vertices/.test(document.getElementById("source-name").textContent), null, patience);
  await tab.close();
});

test("work is canceled, and begun again", async () => {
  const { page, context: tab } = await start();
  await page.click("[data-example=remeshed]");
  await page.waitForFunction(() => document.getElementById("bar").value > 0, null, patience);
  await page.click("#cancel");
  await page.waitForSelector("#cancel", { state: "hidden" });
  assert.ok((await page.isHidden("#result")) && (await page.isHidden("#error")));
  await page.click("#options summary");
  await page.selectOption("#method", "nearest");
  await page.click("#match");
  await resultOf(page);
  await tab.close();
});

test("a tab is closed while it works", async () => {
  const { page, context: tab } = await start();
  await page.click("[data-example=remeshed]");
  await page.waitForSelector("#cancel:not([hidden])");
  await page.close();
  const next = await tab.newPage();
  await next.goto(site.address);
  assert.match(await text(next, "input"), /Drop a mesh here/);
  await tab.close();
});

test("landmarks are clicked and used", async () => {
  const { page, context: tab } = await start();
  await page.click("[data-example=shuffled]");
  const frame = await resultOf(page);
  await frame.check("#picking");
  const box = await page.locator("#viewer").boundingBox();
  const click = async (side, vertex) => {
    const at = await frame.evaluate(([side, vertex]) => window.counterpart.screenPosition(side, vertex), [side, vertex]);
    await page.mouse.click(box.x + at.x, box.y + at.y);
  };
  // A vertex that is seen on both sides.
  const [from, to] = await frame.evaluate(() => {
    const { scene } = window.counterpart;
    const seen = (side, vertex) => window.counterpart.screenPosition(side, vertex).facing;
    const { image } = scene.maps[0];
    const isSeen = (image, v) => image >= 0 && seen("source", v) && seen("target", image);
    const v = image.findIndex(isSeen);
    return [v, image[v]];
  });
  await click("source", from);
  await click("target", to);
  assert.equal(await text(page, "match-again"), "Match again with 1 landmark");
  await picture(page, "landmarks");
  await page.click("#match-again");
  await page.waitForSelector("#cancel:not([hidden])");
  await resultOf(page);
  assert.match(await text(page, "summary"), /by spectral in/);
  await tab.close();
});

test("a phone shows it all without scrolling sideways", async () => {
  const { page, context: tab } = await start({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await picture(page, "phone_start");
  await page.click("[data-example=shuffled]");
  await resultOf(page);
  await picture(page, "phone");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  await tab.close();
});

/** The surface of a cube, each side in n x n squares, as text. */
function gridOfCube(n) {
  const lines = [];
  const faces = [];
  const numbers = new Map();
  const vertex = (p) => {
    const key = p.join(" ");
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size + 1);
      lines.push(`v ${key}`);
    }
    return numbers.get(key);
  };
  for (let axis = 0; axis < 3; axis++) {
    for (const end of [0, n]) {
      const at = (i, j) => {
        const p = [0, 0, 0];
        p[axis] = end;
        p[(axis + 1) % 3] = i;
        p[(axis + 2) % 3] = j;
        return vertex(p);
      };
      for (let i = 0; i < n; i++) {
        for (let j = 0; j < n; j++) {
          const corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
          faces.push(`f ${(end ? corners : corners.reverse()).join(" ")}`);
        }
      }
    }
  }
  return [...lines, ...faces, ""].join("\n");
}
