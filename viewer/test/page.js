// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Opens pages that `counterpart view` wrote and uses them as a person would: what the tests share.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before } from "node:test";
import { launch } from "./browser.js";
import { writePage, writePair } from "./pair.js";

export const pair = writePair(70, 32);
export const screenshots = process.env.SCREENSHOTS ?? join(pair.folder, "screenshots");
mkdirSync(screenshots, { recursive: true });

export let browser;
export let file;
before(async () => {
  browser = await launch();
  file = writePage(pair, ["truth.txt", "worse.txt"], "--truth", join(pair.folder, "truth.txt"));
});
after(() => browser?.close());

export const answer = (page) => page.locator("#answer").innerText();
export const highlighted = (page) => page.evaluate(() => window.counterpart.highlighted());
export const position = (page, side, vertex) =>
  page.evaluate(([side, vertex]) => window.counterpart.screenPosition(side, vertex), [side, vertex]);

/** A vertex of that side that the mouse finds, and where. Vertices on the far side are hidden by others. */
export async function hoverVisible(page, side, accept = () => true) {
  for (let vertex = 5; vertex < pair.count; vertex += 37) {
    if (!accept(vertex)) continue;
    const at = await position(page, side, vertex);
    if (!at.facing) continue;
    await page.mouse.move(at.x, at.y);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    if ((await highlighted(page))[side].includes(vertex)) return { vertex, at };
  }
  return assert.fail("no vertex can be hovered");
}

/** Mean difference of two PNG screenshots' bytes would need a decoder; equal pictures have equal bytes. */
export async function stagePicture(page, name) {
  return page.screenshot({ path: join(screenshots, `${name}.png`) });
}

/** Color of a pixel of the overlay, once it is drawn: what changes is drawn in the next frame. */
export const overlayPixel = (page, at) =>
  page.evaluate(async ({ x, y }) => {
    await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
    const canvas = document.getElementById("overlay");
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / box.width;
    return [...canvas.getContext("2d").getImageData((x - box.left) * scale, (y - box.top) * scale, 1, 1).data];
  }, at);
