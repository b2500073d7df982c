// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What is drawn: modes, figures, captions, texture; and how fast.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser.js";
import { browser, file, pair, position, screenshots, stagePicture } from "./page.js";
import { program, writePage, writePair } from "./pair.js";
import { writeTeeth, writeTextured } from "./textured.js";

const modes = ["colors", "checker", "error", "frontiers", "plain"];

test("every mode looks different, on both meshes, without complaint", async () => {
  const { page, context, complaints } = await open(browser, file);
  await page.selectOption("#map", "1");
  const seen = new Set();
  for (const mode of modes) {
    await page.locator(`#modes input[value=${mode}]`).check();
    await page.waitForTimeout(50);
    seen.add((await page.locator("#meshes").screenshot({ path: join(screenshots, `${mode}.png`) })).toString("base64"));
  }
  assert.equal(seen.size, modes.length);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("frontiers begin on the largest component", async () => {
  const tooth = ["v 9 0 0", "v 9 1 0", "v 9 0 1", "v 9.5 0 0", "f 1 3 2", "f 1 2 4", "f 2 3 4", "f 1 4 3"];
  const behind = (line) => (line[0] === "f" ? `f ${line.slice(2).split(" ").map((v) => Number(v) + 4).join(" ")}` : line);
  const body = readFileSync(join(pair.folder, "source.obj"), "utf8").trim().split("\n").map(behind);
  const [source, page_file] = ["toothed.obj", "toothed.html"].map((name) => join(pair.folder, name));
  writeFileSync(source, [...tooth, ...body].join("\n") + "\n");
  execFileSync(program, ["view", source, source, "-q", "-o", page_file]);
  const { page, context } = await open(browser, page_file);
  await page.locator("#modes input[value=frontiers]").check();
  const base = Number(/from vertex (\d+)/.exec(await page.locator("#legend").innerText())[1]);
  assert.ok(base >= 4, `vertex ${base} is on the small one`);
  await context.close();
});

for (const [name, viewport, least] of [["a desktop", { width: 1400, height: 900 }, 0.55], ["a phone", { width: 390, height: 844 }, 0.35]])
  test(`on ${name} upright figures side by side use the height that there is, and stay in their panes`, async () => {
    const path = (file) => join(pair.folder, file);
    const tall = readFileSync(path("source.obj"), "utf8").replaceAll(/^v (\S+)/gm, (_, x) => `v ${0.3 * x}`);
    writeFileSync(path("tall.obj"), tall);
    writeFileSync(path("itself.txt"), Array.from({ length: pair.count }, (_, v) => `${v}\n`).join(""));
    const maps = Array(4).fill(["--map", path("itself.txt")]).flat();
    const html = path("tall.html");
    execFileSync(program, ["view", path("tall.obj"), path("tall.obj"), ...maps, "--up", "y", "-q", "-o", html]);
    const { page, context } = await open(browser, html, { viewport });
    await page.locator("#comparing").check();
    await page.locator("#meshes").focus();
    for (let turn = 0; turn < 8; turn++) {
      const { xs, ys, left, right, height } = await page.evaluate((count) => {
        const points = [];
        for (let v = 0; v < count; v++) points.push(window.counterpart.screenPosition("target", v, 0));
        const box = document.querySelector("#map-names div").getBoundingClientRect();
        const next = document.querySelectorAll("#map-names div")[1].getBoundingClientRect();
        const height = document.getElementById("stage").clientHeight;
        return { xs: points.map((p) => p.x), ys: points.map((p) => p.y), left: box.left - 10, right: next.left - 10, height };
      }, pair.count);
      const share = (Math.max(...ys) - Math.min(...ys)) / height;
      assert.ok(share > least, `${share} of the height`);
      assert.ok(Math.min(...xs) >= left && Math.max(...xs) <= right, `turned ${turn} times it leaves its pane`);
      for (let i = 0; i < 4; i++) await page.keyboard.press("ArrowRight");
    }
    await stagePicture(page, `tall_${viewport.width}`);
    await context.close();
  });

for (const [name, viewport] of [["a desktop", { width: 1400, height: 900 }], ["a phone", { width: 390, height: 844 }]])
  test(`on ${name} no caption lies on a mesh, on another caption or over the edge`, async () => {
    const long = "another part, quite far away: 28 % of the surface goes elsewhere";
    const maps = [1, 2, 3, 4].map((i) => `${long} ${i}.txt`);
    for (const map of maps) writeFileSync(join(pair.folder, map), readFileSync(join(pair.folder, "worse.txt")));
    const { page, context } = await open(browser, writePage(pair, maps), { viewport });
    for (const comparing of [false, true]) {
      await page.locator("#comparing").setChecked(comparing);
      const { names, meshes, stage } = await page.evaluate((count) => {
        const box = (element) => element.getBoundingClientRect().toJSON();
        const shown = [...document.querySelectorAll(".pane-name")].filter((name) => !name.hidden);
        const points = [];
        for (let vertex = 0; vertex < count; vertex += 3) {
          points.push(window.counterpart.screenPosition("source", vertex));
          for (const map of [0, 1, 2, 3]) points.push(window.counterpart.screenPosition("target", vertex, map));
        }
        return { names: shown.map(box), meshes: points, stage: box(document.getElementById("stage")) };
      }, pair.count);
      assert.equal(names.length, comparing ? 5 : 2);
      const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      for (const [i, a] of names.entries()) {
        assert.ok(a.left >= stage.left && a.right <= stage.right && a.bottom <= stage.bottom, JSON.stringify(a));
        assert.ok(names.every((b, j) => i === j || apart(a, b)), `caption ${i} lies on another`);
        const covered = meshes.filter(({ x, y }) => x > a.left && x < a.right && y > a.top && y < a.bottom);
        assert.deepEqual(covered, [], `caption ${i} lies on a mesh`);
      }
      await stagePicture(page, `captions_${viewport.width}_${comparing}`);
    }
    await context.close();
  });

test("lines and the morph change the picture; the source's vertices move to their counterparts", async () => {
  const { page, context } = await open(browser, file);
  const plain = await stagePicture(page, "without_lines");
  await page.locator("#lines").fill("100");
  const lines = await stagePicture(page, "lines");
  assert.notDeepEqual(lines, plain);
  await page.locator("#lines").fill("0");
  const before = await position(page, "source", 100);
  await page.locator("#morph").fill("100");
  const halfWidth = (await page.locator("#meshes").boundingBox()).width / 2;
  const morphed = await position(page, "source", 100);
  const counterpart = await position(page, "target", pair.truth[100]);
  assert.ok(Math.hypot(morphed.x - before.x, morphed.y - before.y) > 1);
  assert.ok(Math.hypot(morphed.x + halfWidth - counterpart.x, morphed.y - counterpart.y) < 1, "at its counterpart");
  await stagePicture(page, "morph");
  await context.close();
});

test("texture: each mesh with its own image, the right way up, and its own colors", async () => {
  const folder = writeTextured();
  const file = join(folder, "view.html");
  execFileSync(program, ["view", join(folder, "source.obj"), join(folder, "target.ply"), "-q", "-o", file]);
  const { page, context, complaints } = await open(browser, file);
  const pixel = (side, vertex) =>
    page.evaluate(([side, vertex]) => {
      const canvas = document.getElementById("meshes");
      const at = window.counterpart.screenPosition(side, vertex);
      const box = canvas.getBoundingClientRect();
      window.counterpart.measureFrame();
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      copy.drawImage(canvas, 0, 0);
      const scale = canvas.width / box.width;
      return [...copy.getImageData((at.x - box.left) * scale, (at.y - box.top) * scale, 1, 1).data];
    }, [side, vertex]);
  const isMostly = ([r, g, b], channel) => {
    const largest = Math.max(r, g, b);
    return [r, g, b][channel] === largest && largest > 1.5 * Math.min(r, g, b);
  };
  await page.locator("#modes input[value=texture]").check();
  await page.waitForTimeout(200);
  await stagePicture(page, "texture");
  const [bottom, top] = [await pixel("source", 8 * 2 + 4), await pixel("source", 8 * 6 + 4)];
  assert.ok(isMostly(top, 0) && isMostly(bottom, 2), `red above blue: ${top} / ${bottom}`);
  const colored = await pixel("target", 8 * 4 + 4);
  assert.ok(isMostly(colored, 1), `the target's own green: ${colored}`);
  assert.ok(await page.locator("#legend").isHidden());
  await page.locator("#morph").fill("100");
  assert.ok(isMostly(await pixel("source", 8 * 6 + 4), 0), "the image stays while the vertices move");
  await page.locator("#modes input[value=plain]").check();
  assert.ok(!isMostly(await pixel("source", 8 * 6 + 4), 0));
  assert.deepEqual(complaints, []);
  await context.close();
  const { page: other, context: closed } = await open(browser, writePage(writePair(12, 9), ["truth.txt"]));
  assert.equal(await other.locator("#modes input[value=texture]").count(), 0, "no texture, no such mode");
  await closed.close();
});

test("parts alike are shown by kind", async () => {
  const folder = writeTeeth();
  const file = join(folder, "view.html");
  execFileSync(program, ["view", join(folder, "source.obj"), join(folder, "target.obj"), "-q", "-o", file]);
  const { page, context } = await open(browser, file);
  await page.locator("#modes input[value=values]").check();
  assert.match(await page.locator("#legend").innerText(), /parts alike/);
  await context.close();
});

test("a large pair: size and times", async () => {
  const big = writePair(400, 250);
  const page = writePage(big, ["truth.txt"]);
  const opened = await open(browser, page);
  const frame = await opened.page.evaluate(() => {
    const times = Array.from({ length: 9 }, () => window.counterpart.measureFrame());
    return times.sort((a, b) => a - b)[4];
  });
  const megabytes = statSync(page).size / 1e6;
  const figures = { vertices: big.count, megabytes, open_ms: Math.round(opened.milliseconds), frame_and_pick_ms: frame };
  console.log(JSON.stringify({ benchmark: "viewer", ...figures }));
  assert.ok(megabytes < 20);
  assert.deepEqual(opened.complaints, []);
  await opened.context.close();
});
