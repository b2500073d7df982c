// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Pointing, selecting and turning, by mouse, keyboard and touch.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser.js";
import { answer, browser, file, highlighted, hoverVisible, overlayPixel, pair, position, stagePicture } from "./page.js";
import { writePage } from "./pair.js";

test("a hovered source vertex lights up its counterpart", async () => {
  const { page, context, complaints, requests } = await open(browser, file);
  const { vertex } = await hoverVisible(page, "source");
  assert.deepEqual(await highlighted(page), { source: [vertex], target: [pair.truth[vertex]] });
  assert.match(await answer(page), new RegExp(`target vertex ${pair.truth[vertex]}\\b.*exact`));
  assert.equal(await page.inputValue("#vertex"), String(vertex));
  const marker = await overlayPixel(page, await position(page, "target", pair.truth[vertex]));
  assert.equal(marker[0], 255, `the counterpart's marker is drawn: ${marker}`);
  assert.ok(marker[3] > 0);
  await stagePicture(page, "hover");
  await page.mouse.move(2, 2);
  assert.deepEqual(await highlighted(page), { source: [], target: [] });
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests.filter((url) => !url.startsWith("file:") && !url.startsWith("data:")), []);
  await context.close();
});

test("a hovered target vertex lights up the source vertices that map to it", async () => {
  const { page, context } = await open(browser, file);
  const { vertex } = await hoverVisible(page, "target");
  const source = pair.truth.indexOf(vertex);
  assert.deepEqual(await highlighted(page), { source: [source], target: [vertex] });
  assert.match(await answer(page), new RegExp(`Target vertex ${vertex}\\b.*source vertex ${source}\\b`));
  await context.close();
});

test("a click selects, Escape lets go, and a number typed in selects too", async () => {
  const { page, context } = await open(browser, file);
  const { vertex, at } = await hoverVisible(page, "source");
  await page.mouse.click(at.x, at.y);
  await page.mouse.move(2, 2);
  assert.deepEqual((await highlighted(page)).source, [vertex]);
  await page.locator("#meshes").press("Escape");
  assert.deepEqual((await highlighted(page)).source, []);
  await page.fill("#vertex", "17");
  assert.deepEqual(await highlighted(page), { source: [17], target: [pair.truth[17]] });
  await page.fill("#vertex", String(pair.count));
  assert.deepEqual((await highlighted(page)).source, [17], "a number that is no vertex selects nothing");
  await context.close();
});

test("the number follows the mouse also while it has the focus", async () => {
  const { page, context } = await open(browser, file);
  await page.focus("#vertex");
  await page.fill("#vertex", "17");
  const { vertex } = await hoverVisible(page, "source", (v) => v !== 17);
  assert.equal(await page.inputValue("#vertex"), String(vertex));
  await context.close();
});

test("views are linked until they are not; the keyboard turns them", async () => {
  const { page, context } = await open(browser, file);
  const both = async () => {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    return [await position(page, "source", 9), await position(page, "target", 9)];
  };
  const moved = (a, b) => a.map((p, i) => Math.hypot(p.x - b[i].x, p.y - b[i].y) > 1);
  const start = await both();
  await page.locator("#meshes").focus();
  await page.keyboard.press("ArrowRight");
  const turned = await both();
  assert.deepEqual(moved(start, turned), [true, true]);
  await page.locator("#linked").uncheck();
  await page.mouse.move(300, 300);
  await page.mouse.down();
  await page.mouse.move(380, 330, { steps: 4 });
  await page.mouse.up();
  assert.deepEqual(moved(turned, await both()), [true, false]);
  await page.locator("#reset").click();
  assert.deepEqual(moved(start, await both()), [false, false]);
  await context.close();
});

test("every control is reached by Tab and has a name", async () => {
  const { page, context } = await open(browser, file);
  const reached = [];
  for (let i = 0; i < 12; i++) {
    await page.keyboard.press("Tab");
    const item = await page.evaluate(() => {
      const active = document.activeElement;
      const name = active.getAttribute("aria-label") ?? active.labels?.[0]?.innerText ?? active.innerText;
      return { id: active.id || active.name, name };
    });
    if (item.id) reached.push(item);
  }
  const ids = reached.map((item) => item.id);
  for (const id of ["map", "meshes", "vertex", "mode", "lines", "morph", "linked", "reset"])
    assert.ok(ids.includes(id), `${id} is reached: ${ids}`);
  assert.ok(reached.every((item) => item.name?.trim()), JSON.stringify(reached));
  await context.close();
});

test("on a phone, dark: everything is on the screen, a tap selects", async () => {
  const viewport = { width: 390, height: 844 };
  const phone = { viewport, deviceScaleFactor: 2, hasTouch: true, isMobile: true, colorScheme: "dark" };
  const { page, context, complaints } = await open(browser, file, phone);
  const size = await page.evaluate(() => ({
    overflow: document.documentElement.scrollWidth - window.innerWidth,
    stage: document.getElementById("stage").clientHeight,
    background: getComputedStyle(document.body).backgroundColor,
  }));
  assert.ok(size.overflow <= 0, `nothing sticks out sideways (${size.overflow})`);
  assert.ok(size.stage > 350, `the meshes have room (${size.stage})`);
  const light = await open(browser, file);
  assert.notEqual(size.background, await light.page.evaluate(() => getComputedStyle(document.body).backgroundColor));
  await light.context.close();
  const { at, vertex } = await hoverVisible(page, "source");
  await page.mouse.move(2, 2);
  await page.touchscreen.tap(at.x, at.y);
  assert.deepEqual(await highlighted(page), { source: [vertex], target: [pair.truth[vertex]] });
  await stagePicture(page, "phone_dark");
  assert.deepEqual(complaints, []);
  await context.close();
});

for (const [name, viewport] of [["a desktop", { width: 1280, height: 760 }], ["a phone", { width: 390, height: 844 }]])
  test(`on ${name} the meshes stay where they are when one is pointed at`, async () => {
    const maps = [1, 2, 3, 4].map((i) => `another part, quite far away: 28 % of the surface goes elsewhere ${i}.txt`);
    for (const map of maps) writeFileSync(join(pair.folder, map), readFileSync(join(pair.folder, "worse.txt")));
    const { page, context } = await open(browser, writePage(pair, maps), { viewport });
    const height = () => page.evaluate(() => document.getElementById("stage").clientHeight);
    const before = await height();
    const { vertex } = await hoverVisible(page, "source");
    assert.match(await answer(page), new RegExp(`goes elsewhere 4: (${pair.worse[vertex]}|none)`));
    assert.equal(await height(), before);
    await stagePicture(page, `pointed_${viewport.width}`);
    await context.close();
  });
