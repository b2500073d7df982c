// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Opens pages that `counterpart view` wrote and uses them as a person would.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, open } from "./browser.js";
import { program, writePage, writePair } from "./pair.js";
import { writeTeeth, writeTextured } from "./textured.js";

const modes = ["colors", "checker", "error", "frontiers", "plain"];
const pair = writePair(70, 32);
const screenshots = process.env.SCREENSHOTS ?? join(pair.folder, "screenshots");
mkdirSync(screenshots, { recursive: true });

let browser;
let file;
before(async () => {
  browser = await launch();
  file = writePage(pair, ["truth.txt", "worse.txt"], "--truth", join(pair.folder, "truth.txt"));
});
after(() => browser?.close());

const answer = (page) => page.locator("#answer").innerText();
const highlighted = (page) => page.evaluate(() => window.counterpart.highlighted());
const position = (page, side, vertex) =>
  page.evaluate(([side, vertex]) => window.counterpart.screenPosition(side, vertex), [side, vertex]);

/** A vertex of that side that the mouse finds, and where. Vertices on the far side are hidden by others. */
async function hoverVisible(page, side, accept = () => true) {
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
async function stagePicture(page, name) {
  return page.screenshot({ path: join(screenshots, `${name}.png`) });
}

/** Color of a pixel of the overlay, once it is drawn: what changes is drawn in the next frame. */
const overlayPixel = (page, at) =>
  page.evaluate(async ({ x, y }) => {
    await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
    const canvas = document.getElementById("overlay");
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / box.width;
    return [...canvas.getContext("2d").getImageData((x - box.left) * scale, (y - box.top) * scale, 1, 1).data];
  }, at);

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

test("the number follows the mouse also while it has the focus", async () => {
  const { page, context } = await open(browser, file);
  await page.focus("#vertex");
  await page.fill("#vertex", "17");
  const { vertex } = await hoverVisible(page, "source", (v) => v !== 17);
  assert.equal(await page.inputValue("#vertex"), String(vertex));
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

test("parts alike are shown by kind", async () => {
  const folder = writeTeeth();
  const file = join(folder, "view.html");
  execFileSync(program, ["view", join(folder, "source.obj"), join(folder, "target.obj"), "-q", "-o", file]);
  const { page, context } = await open(browser, file);
  await page.locator("#modes input[value=values]").check();
  assert.match(await page.locator("#legend").innerText(), /parts alike/);
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
