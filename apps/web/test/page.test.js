// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Uses the built page as a person would.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { bytesOf, folder as native, run } from "../../../javascript/test/native.js";
import { folder, write, writePair } from "./meshes.js";
import { serve } from "./site.js";
import { canMatch, give, matched, picture, resultOf, saved, text, visits } from "./visit.js";

const start = visits();

test("the page says that files stay, and its policies let nothing out", async () => {
  const elsewhere = await serve({});
  const heard = [];
  elsewhere.server.on("request", ({ url }) => heard.push(url));
  const send = (to) => fetch(to, { mode: "no-cors" }).then(() => "sent", () => "refused");
  assert.equal(await send(`${elsewhere.address}test`), "sent");
  // Not at once: what a test runs itself may.
  const evaluate = () => new Promise((allowed, refused) => {
    setTimeout(() => {
      try {
        allowed(eval("1"));
      } catch {
        refused();
      }
    });
  }).catch(() => "refused");
  const { page, end } = await start();
  assert.match(await text(page, "input"), /Drop a mesh here/);
  assert.match(await page.innerText("header"), /Your files stay on this device: nothing is sent anywhere/);
  await page.waitForFunction(() => document.getElementById("formats").textContent.includes(".glb"));
  for (const ending of [".obj", ".ply", ".off", ".stl", ".gltf"]) assert.ok((await text(page, "formats")).includes(ending));
  const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  assert.ok(policy.startsWith("default-src 'none'") && !/unsafe-(inline|eval)/.test(policy.replace("wasm-unsafe-eval", "")));
  await page.click("[data-example=shuffled]");
  const frame = await resultOf(page);
  for (const place of [page, frame, page.workers()[0]]) {
    assert.equal(await place.evaluate(send, `${elsewhere.address}page`), "refused");
    assert.equal(await place.evaluate(evaluate), "refused");
  }
  assert.deepEqual(heard, ["/test"]);
  elsewhere.server.close();
  await end([/Content Security Policy/]);
});

for (const [kind, method, verdict] of [
  ["shuffled", "exact", /^use$/],
  ["remeshed", "spectral", /^(use|check)$/],
  ["part", "partial", /^(use|check)$/],
]) {
  test(`the example '${kind}' is matched by ${method}`, async (context) => {
    const { page, end } = await start();
    await page.click(`[data-example=${kind}]`);
    const frame = await resultOf(page);
    context.diagnostic(await text(page, "summary"));
    assert.match(await text(page, "summary"), new RegExp(`by ${method} in`));
    assert.match(await text(page, "verdict"), verdict);
    const offered = await frame.locator("#map option").allInnerTexts();
    context.diagnostic(`maps: ${offered.join(", ")}`);
    assert.ok(kind !== "remeshed" || offered.length > 1);
    assert.deepEqual(await frame.locator("#values option").allInnerTexts(), ["Confidence"]);
    await picture(page, kind);
    await end();
  });
}

test("without threads the page does the same", async () => {
  const texts = [];
  for (const serviceWorkers of ["allow", "block"]) {
    const { page, end } = await start({ serviceWorkers });
    assert.equal(await page.evaluate(() => window.crossOriginIsolated), serviceWorkers === "allow");
    await page.click("[data-example=part]");
    await resultOf(page);
    texts.push((await saved(page, "save-map")).bytes.toString());
    await end();
  }
  assert.equal(texts[0], texts[1]);
});

test("of an unlike pair it says what the program says: not to use it, why, and probable causes", async () => {
  const { source } = writePair(60, 40, "ring");
  // Alike in no way in itself, so that rounding decides nothing.
  const stretched = (_, x, y, z) => `v ${x} ${1.4 * y + 0.2 * x} ${2 * z + 0.3 * x * y}`;
  const cube = write("cube.obj", gridOfCube(12).replace(/^v (\S+) (\S+) (\S+)/gm, stretched));
  run("match", source, cube, "-o", "unlike.txt", "--report", "unlike.json");
  const said = JSON.parse(bytesOf("unlike.json").toString());
  const { page, end } = await start();
  await give(page, source, cube);
  await matched(page);
  assert.equal(await text(page, "verdict"), said.verdict);
  assert.notEqual(said.verdict, "use");
  assert.equal(await text(page, "verdict-reason"), said.verdict_reason);
  await page.click("#messages-box summary");
  for (const [id, messages] of [["causes", said.probable_causes], ["messages", said.messages]]) {
    assert.ok(messages.length > 0);
    const names = { map: "", source: "ring.ply: ", target: "cube.obj: " };
    const sentences = messages.map(({ sentence, where }) => names[where.subject] + sentence);
    assert.deepEqual(await page.locator(`#${id} li`).allInnerTexts(), sentences);
  }
  await picture(page, "unlike");
  await end();
});

test("work is canceled, and begun again", async () => {
  const { page, end } = await start();
  await page.click("[data-example=remeshed]");
  await page.waitForFunction(() => document.getElementById("bar").value > 0);
  await page.waitForFunction(() => /^about \d+ (s|min) left$/.test(document.getElementById("left").textContent));
  await picture(page, "running");
  await page.click("#cancel");
  await page.waitForSelector("#cancel", { state: "hidden" });
  assert.ok((await page.isHidden("#result")) && (await page.isHidden("#error")));
  await page.click("#options summary");
  await page.selectOption("#method", "nearest");
  await matched(page);
  await end();
});

test("other files while it works are taken in place of it", async () => {
  const { source, target } = writePair(20, 12, "small");
  const { page, end } = await start();
  await page.click("[data-example=remeshed]");
  await page.waitForFunction(() => document.getElementById("bar").value > 0);
  await page.setInputFiles("#source-file", [source, target]);
  await page.waitForFunction(() => /small_bent/.test(document.getElementById("target-name").textContent));
  await canMatch(page);
  await matched(page);
  assert.match(await text(page, "summary"), /240 of 240/);
  await end();
});

test("a tab is closed while it works", async () => {
  const { page, tab, end } = await start();
  await page.click("[data-example=remeshed]");
  await page.waitForSelector("#cancel:not([hidden])");
  const address = page.url();
  await page.close();
  const next = await tab.newPage();
  await next.goto(address);
  assert.match(await text(next, "input"), /Drop a mesh here/);
  await end();
});

/** Clicks vertices of the viewer that are seen on both sides: one of each mesh. Returns them. */
async function pickLandmark(page, frame, nth) {
  const pair = await frame.evaluate((skipped) => {
    const { image } = window.counterpart.scene.maps[0];
    const isSeen = (side, vertex) => window.counterpart.screenPosition(side, vertex).facing;
    const pairs = Array.from(image, (to, from) => [from, to]);
    return pairs.filter(([from, to]) => to >= 0 && isSeen("source", from) && isSeen("target", to))[skipped];
  }, nth);
  await page.evaluate(() => window.scrollTo(0, 0));
  const box = await page.locator("#viewer").boundingBox();
  for (const [i, side] of ["source", "target"].entries()) {
    const at = await frame.evaluate(([side, vertex]) => window.counterpart.screenPosition(side, vertex), [side, pair[i]]);
    await page.mouse.click(box.x + at.x, box.y + at.y);
  }
  return pair;
}

test("landmarks are clicked and used, and others are added to them", async () => {
  run("deform", "body", "a.ply", "--subdivisions", "1");
  run("deform", "a.ply", "b.ply", "--bend", "40", "--shuffle", "2");
  const { page, end } = await start();
  await give(page, join(native, "a.ply"), join(native, "b.ply"));
  let frame = await matched(page);
  await frame.check("#picking");
  const landmark = await pickLandmark(page, frame, 0);
  assert.equal(await text(page, "match-again"), "Match again with 1 landmark");
  await picture(page, "landmarks");
  await page.click("#match-again");
  await page.waitForSelector("#cancel:not([hidden])");
  frame = await resultOf(page);
  assert.match(await text(page, "summary"), /by spectral in/);
  write("landmarks.txt", landmark.join(" "));
  run("match", "a.ply", "b.ply", "-o", "landmarks_map.txt", "--landmarks", join(folder, "landmarks.txt"));
  assert.ok((await saved(page, "save-map")).bytes.equals(bytesOf("landmarks_map.txt")));
  assert.ok(await page.isHidden("#match-again"));
  assert.equal(await frame.locator("#landmarks").innerText(), "1 pair");
  await frame.check("#picking");
  // One at the rim of a mesh may be missed.
  for (const nth of [50, 100, 200, 300]) {
    await pickLandmark(page, frame, nth);
    if ((await frame.locator("#landmarks").innerText()) === "2 pairs") break;
  }
  assert.equal(await text(page, "match-again"), "Match again with 2 landmarks");
  await frame.click("#clear-landmarks");
  assert.equal(await text(page, "match-again"), "Match again with no landmarks");
  await end();
});

test("a phone shows it all without scrolling sideways", async () => {
  const { page, end } = await start({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await picture(page, "phone_start");
  await page.click("[data-example=part]");
  await resultOf(page);
  await picture(page, "phone");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  await end();
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
