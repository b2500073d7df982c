// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What a person does on the page.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before } from "node:test";
import { folder } from "./meshes.js";
import { built, launch, serve } from "./site.js";

export const patience = { timeout: 600_000 };
const screenshots = process.env.SCREENSHOTS ?? join(folder, "screenshots");
mkdirSync(screenshots, { recursive: true });

/** Calls `visit` for each visit of a file of tests; a browser and the page's server last as long as these. */
export function visits() {
  const open = {};
  before(async () => {
    open.site = await serve({ project: built("page") });
    open.browser = await launch();
  });
  after(async () => {
    await open.browser?.close();
    open.site?.server.close();
  });
  return (options) => visit(open.browser, `${open.site.address}project/`, options);
}

/** Opens the page, with threads unless `serviceWorkers` is "block". Its `end` checks that it asked for nothing from elsewhere and
 * that nothing went wrong unsaid. */
async function visit(browser, address, options = {}) {
  const tab = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await tab.newPage();
  page.setDefaultTimeout(patience.timeout);
  const complaints = [];
  const requests = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  tab.on("request", (request) => requests.push(request.url()));
  const start = performance.now();
  await page.goto(address, { waitUntil: "domcontentloaded" });
  if (options.serviceWorkers !== "block")
    await page.waitForFunction(() => window.crossOriginIsolated && document.readyState !== "loading");
  const milliseconds = performance.now() - start;
  const end = async (expected = []) => {
    const known = [/Service Worker registration blocked by Playwright/, ...expected];
    assert.deepEqual(complaints.filter((said) => !known.some((pattern) => pattern.test(said))), []);
    assert.deepEqual(requests.filter((url) => !url.startsWith(address) && !/^(data|blob):/.test(url)), []);
    await tab.close();
  };
  return { page, tab, milliseconds, end };
}

export const picture = (page, name) => page.screenshot({ path: join(screenshots, `${name}.png`), fullPage: true });
export const text = (page, id) => page.locator(`#${id}`).innerText();

/** Waits for a result and for its view. */
export async function resultOf(page) {
  await page.waitForSelector("#result:not([hidden]), #error:not([hidden])");
  assert.ok(await page.isHidden("#error"), await page.locator("#error").textContent());
  const frame = await (await page.waitForSelector("#viewer:not([hidden])")).contentFrame();
  await frame.waitForFunction(() => window.counterpart?.frames > 0, null, patience);
  await page.waitForSelector("#cancel", { state: "hidden" });
  return frame;
}

export const canMatch = (page) => page.waitForFunction(() => !document.getElementById("match").disabled);

/** Files for each side; of several, all at once. */
export async function give(page, source, target) {
  await page.setInputFiles("#source-file", source);
  await page.waitForFunction(() => /vertices/.test(document.getElementById("source-name").textContent));
  await page.setInputFiles("#target-file", target);
  await canMatch(page);
}

export async function matched(page) {
  await page.click("#match");
  return resultOf(page);
}

/** The seconds that the page says it took. */
export async function secondsOf(page) {
  return Number(/in ([\d.]+) s/.exec(await text(page, "summary"))[1]);
}

export async function saved(page, id) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${id}`)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}
