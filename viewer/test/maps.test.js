// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What the page tells of maps, one or several.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser.js";
import { answer, browser, file, highlighted, overlayPixel, pair, stagePicture } from "./page.js";
import { program, writePage, writePair } from "./pair.js";

test("several maps: the list switches, and errors and unmatched vertices are told", async () => {
  const { page, context } = await open(browser, file);
  assert.deepEqual(await page.locator("#map option").allInnerTexts(), ["truth", "worse"]);
  assert.match(await page.locator("#stats").innerText(), /100\.00 % exact/);
  await page.selectOption("#map", "1");
  assert.doesNotMatch(await page.locator("#stats").innerText(), /100\.00 % exact/);
  await page.fill("#vertex", "14");
  assert.deepEqual((await highlighted(page)).target, [pair.worse[14]]);
  assert.match(await answer(page), new RegExp(`error [0-9.]+ % of √area · truth ${pair.truth[14]}\\b`));
  await page.fill("#vertex", "3");
  assert.deepEqual(await highlighted(page), { source: [3], target: [] });
  assert.match(await answer(page), /target vertex none/);
  await context.close();
});

test("the page tells of a map what `evaluate` tells of it", async () => {
  const { page, context } = await open(browser, file);
  await page.selectOption("#map", "1");
  const path = (name) => join(pair.folder, name);
  const asked = [path("source.obj"), path("target.obj"), path("worse.txt"), "--truth", path("truth.txt")];
  const said = execFileSync(program, ["evaluate", ...asked], { encoding: "utf8" });
  const stats = await page.locator("#stats").innerText();
  const share = (100 * Number(/(\d+) \([0-9.]+ %\) exactly right/.exec(said)[1])) / pair.count;
  assert.ok(stats.includes(`${share.toFixed(2)} % exact`), `${stats} against ${said}`);
  const mean = Number(/error +mean ([0-9.]+)/.exec(said)[1]);
  assert.ok(Math.abs(Number(/mean error ([0-9.]+)/.exec(stats)[1]) - mean) < 0.01, `${stats} against ${said}`);
  await context.close();
});

test("the error scale can be set", async () => {
  const { page, context } = await open(browser, file);
  await page.selectOption("#map", "1");
  await page.locator("#modes input[value=error]").check();
  const drawn = async () => {
    await page.waitForTimeout(50);
    return (await page.locator("#meshes").screenshot()).toString("base64");
  };
  const automatic = await drawn();
  await page.fill("#scale", "2");
  const set = await drawn();
  assert.notEqual(set, automatic);
  assert.match(await page.locator("#legend").innerText(), /\b2\b/);
  await page.fill("#scale", "");
  assert.equal(await drawn(), automatic);
  await context.close();
});

test("maps side by side: one pane each, which are picked and marked on their own", async () => {
  const { page, context, complaints } = await open(browser, file);
  const alone = await stagePicture(page, "one_map");
  await page.locator("#comparing").check();
  assert.deepEqual(await page.locator("#map-names div").allInnerTexts(), ["truth", "worse"]);
  assert.notDeepEqual(await stagePicture(page, "side_by_side"), alone);
  const vertex = pair.worse.findIndex((image, v) => image >= 0 && image !== pair.truth[v]);
  await page.fill("#vertex", String(vertex));
  const under = (map) => page.evaluate((map) => window.counterpart.highlighted(map).target, map);
  assert.deepEqual([await under(0), await under(1)], [[pair.truth[vertex]], [pair.worse[vertex]]]);
  const width = (await page.locator("#meshes").boundingBox()).width / 3;
  const at = (map) => page.evaluate(([v, map]) => window.counterpart.screenPosition("target", v, map), [9, map]);
  const [first, second] = [await at(0), await at(1)];
  assert.ok(Math.abs(second.x - first.x - width) < 1 && Math.abs(second.y - first.y) < 1, "the same view, a pane apart");
  assert.ok((await overlayPixel(page, await page.evaluate(
    ([v, map]) => window.counterpart.screenPosition("target", v, map), [pair.worse[vertex], 1])))[3] > 0);
  await page.locator("#comparing").uncheck();
  assert.deepEqual(await page.locator("#map-names div").allInnerTexts(), []);
  assert.deepEqual(await stagePicture(page, "one_map_again").then(() => complaints), []);
  await context.close();
});

test("confidence and warnings are those of the map that is shown", async () => {
  const path = (name) => join(pair.folder, name);
  const [source, other, html] = ["source.obj", "stretched.obj", "matched.html"].map(path);
  const stretched = readFileSync(source, "utf8").split("\n").map((line) => {
    const [key, ...numbers] = line.split(" ");
    return key === "v" ? ["v", 1.3 * numbers[0], ...numbers.slice(1)].join(" ") : line;
  });
  const shuffled = stretched.filter((line) => line[0] !== "f").concat(stretched.filter((line) => line[0] === "f").slice(1));
  writeFileSync(other, shuffled.join("\n"));
  const report = path("report.json");
  execFileSync(program, ["view", source, other, "-q", "-o", html, "--report", report]);
  const { verdict, match_messages: messages } = JSON.parse(readFileSync(report, "utf8"));
  const page = await open(browser, html);
  const panel = page.page;
  assert.equal(await panel.locator("#stats .verdict").innerText(), verdict);
  const warnings = messages.filter((message) => message.severity !== "notice");
  assert.equal(await panel.locator("#warnings").isVisible(), warnings.length > 0);
  await panel.evaluate(() => document.getElementById("warnings").setAttribute("open", ""));
  const items = await panel.locator("#warning-list li").allInnerTexts();
  assert.deepEqual(items.map((item, i) => item.includes(warnings[i].sentence)), warnings.map(() => true));
  await panel.locator("#modes input[value=values]").check();
  assert.match(await panel.locator("#legend").innerText(), /Confidence\s+0\s+1/);
  await panel.fill("#vertex", "17");
  assert.match(await answer(panel), /confidence [01]\.\d\d/);
  assert.deepEqual(page.complaints, []);
  await page.context.close();
});

/** A .npy file of one number per vertex. */
function writeNumbers(file, numbers) {
  const header = `{'descr': '<f8', 'fortran_order': False, 'shape': (${numbers.length},), }`;
  const text = Buffer.from(header.padEnd(117) + "\n", "latin1");
  const start = Buffer.from([0x93, ...Buffer.from("NUMPY"), 1, 0, text.length, 0]);
  writeFileSync(file, Buffer.concat([start, text, Buffer.from(Float64Array.from(numbers).buffer)]));
}

test("the scale of shares ends at 0 and 1, that of other numbers at the least and the largest", async () => {
  const sure = join(pair.folder, "sure.npy");
  const lengths = join(pair.folder, "lengths.npy");
  writeNumbers(sure, pair.truth.map((_, v) => 0.8 + (0.15 * v) / pair.count));
  writeNumbers(lengths, pair.truth.map((_, v) => 2 + (3 * v) / (pair.count - 1)));
  const { page, context } = await open(browser, writePage(pair, ["truth.txt"], "--values", sure, "--values", lengths));
  await page.locator("#modes input[value=values]").check();
  assert.match(await page.locator("#legend").innerText(), /sure\s+0\s+1\b/);
  await page.locator("#values").selectOption("1");
  assert.match(await page.locator("#legend").innerText(), /lengths\s+2\s+5\b/);
  await context.close();
});

test("without the truth the error mode is off", async () => {
  const other = writePair(12, 9);
  const { page, context } = await open(browser, writePage(other, ["truth.txt"]));
  assert.ok(await page.locator("#modes input[value=error]").isDisabled());
  assert.ok(await page.locator("#map-field").isHidden());
  await context.close();
});

test("a map that does not fit is an error, and nothing is written", () => {
  const other = writePair(12, 9);
  const output = join(other.folder, "none.html");
  const meshes = ["source.obj", "target.obj"].map((name) => join(other.folder, name));
  const run = (map, ...options) =>
    spawnSync(program, ["view", ...meshes, "--map", map, "-o", output, ...options], { encoding: "utf8" });
  const wrong = run(join(pair.folder, "truth.txt"));
  assert.equal(wrong.status, 1);
  assert.match(wrong.stderr, /^error: .*truth\.txt.*2240 entries.*108 vertices/);
  const truth = run(join(other.folder, "truth.txt"), "--truth", join(pair.folder, "truth.txt"));
  assert.equal(truth.status, 1);
  assert.ok(!existsSync(output));
});

test("names cannot break out of the page", async () => {
  const other = writePair(12, 9);
  const name = "<script>alert(1)<";
  const map = join(other.folder, `${name}.txt`);
  execFileSync("cp", [join(other.folder, "truth.txt"), map]);
  const { page, context, complaints } = await open(browser, writePage(other, [`${name}.txt`, "worse.txt"]));
  assert.equal((await page.locator("#map option").allInnerTexts())[0], name);
  assert.deepEqual(complaints, []);
  await context.close();
});
