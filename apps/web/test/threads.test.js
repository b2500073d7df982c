// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The package in a worker of a page: the same bytes with threads, without, and by the program.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { folder, match, refusal } from "../../../javascript/test/native.js";
import { makePairs, pairs } from "../../../javascript/test/pairs.js";
import { write, folder as pages } from "./meshes.js";
import { built, launch, serve } from "./site.js";

const isolating = { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" };
const sides = [];
let browser;
before(async () => {
  makePairs();
  write("empty.html", "<!doctype html><title>empty</title>");
  browser = await launch();
  for (const headers of [isolating, {}]) {
    const { server, address } = await serve({ package: built("package/dist"), files: folder, pages }, headers);
    const page = await browser.newPage();
    page.setDefaultTimeout(600_000);
    const loaded = [];
    page.context().on("request", (request) => loaded.push(request.url()));
    await page.goto(`${address}pages/empty.html`);
    await page.evaluate(async () => {
      window.counterpart = await (await import("/package/remote.js")).startWorker();
      window.read = async (name) =>
        window.counterpart.readMesh(name, new Uint8Array(await (await fetch(`/files/${name}`)).arrayBuffer()));
    });
    assert.equal(loaded.some((url) => url.endsWith("/library_threads.wasm")), headers === isolating);
    sides.push({ server, page });
  }
});
after(async () => {
  await browser?.close();
  for (const { server } of sides) server.close();
});

/** What a page finds, whole. */
function found(page, source, target, method) {
  return page.evaluate(
    async ([names, method]) => {
      const [a, b] = [await window.read(names[0]), await window.read(names[1])];
      const told = [];
      const onProgress = (done) => void told.push(done);
      const { seconds, ...result } = await window.counterpart.match(a, b, { method, onProgress });
      for (const mesh of [a, b]) window.counterpart.free(mesh);
      const plain = JSON.stringify(result, (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value));
      return { plain, told, took: Object.values(seconds).reduce((sum, s) => sum + s, 0) };
    },
    [[source, target], method],
  );
}

for (const [source, target, method] of pairs) {
  test(`${source} to ${target} by ${method}`, async (context) => {
    const expected = match(source, target, "--method", method);
    const threads = await found(sides[0].page, source, target, method);
    const alone = await found(sides[1].page, source, target, method);
    context.diagnostic(`threads ${threads.took.toFixed(2)} s, one thread ${alone.took.toFixed(2)} s`);
    assert.ok(threads.plain === alone.plain, "threads change the result");
    assert.deepEqual(JSON.parse(threads.plain).targetFromSource, [...expected]);
    for (const { told } of [threads, alone]) {
      assert.equal(told.at(-1), 1);
      assert.deepEqual(told, [...told].sort((x, y) => x - y));
    }
  });
}

// Refused where the spectral bases of both are computed, beside each other.
const unsuitable = {
  "flat.obj": "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nf 1 2 3\nf 3 4 5\nf 2 3 4\n",
  "few.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
};
for (const [name, content] of Object.entries(unsuitable)) {
  test(`what is thrown for ${name} on a thread is said with the program's sentence`, async () => {
    writeFileSync(join(folder, name), content);
    for (const pair of [["small.ply", name], [name, "small.ply"]]) {
      for (const hears of [true, false]) {
        for (const { page } of sides) {
          const { error, message } = await page.evaluate(
            async ([names, hears]) => {
              const [a, b] = [await window.read(names[0]), await window.read(names[1])];
              const options = { method: "spectral", ...(hears && { onProgress: () => {} }) };
              return window.counterpart.match(a, b, options).catch(({ name, message }) => ({ error: name, message }));
            },
            [pair, hears],
          );
          assert.match(error, /^(InvalidInput|UnsuitableMesh)$/);
          assert.ok(message.length > 20 && refusal("match", ...pair, "--method", "spectral", "-o", "map.txt").endsWith(message));
        }
      }
    }
  });
}

test("a broken file is refused with the program's sentence", async () => {
  const content = "v 0 0 0\nv 1 0 zero\n";
  writeFileSync(join(folder, "broken.obj"), content);
  for (const { page } of sides) {
    const message = await page.evaluate(
      (content) => window.counterpart.readMesh("broken.obj", new TextEncoder().encode(content)).catch(({ message }) => message),
      content,
    );
    assert.ok(refusal("inspect", "broken.obj").endsWith(message), message);
  }
});

test("work whose progress is answered with no ends, and the next begins", async () => {
  for (const { page } of sides) {
    const outcome = await page.workers()[0].evaluate(async () => {
      const { compile, libraryAddress, load } = await import("/package/index.js");
      const counterpart = await load(await compile(libraryAddress(self.crossOriginIsolated)));
      const [a, b] = counterpart.example("remeshed");
      let error;
      try {
        counterpart.match(a, b, { onProgress: (done) => done < 0.1 });
      } catch ({ name }) {
        error = name;
      }
      return [error, counterpart.match(a, b, { method: "nearest" }).method];
    });
    assert.deepEqual(outcome, ["Canceled", "nearest"]);
  }
});

test("threads that work are stopped with their worker, and others begin", async () => {
  const { page } = sides[0];
  const outcome = await page.evaluate(async () => {
    const [a, b] = await window.counterpart.example("remeshed");
    const stop = new AbortController();
    const onProgress = (done) => void (done > 0.1 && stop.abort());
    const refused = await window.counterpart.match(a, b, { signal: stop.signal, onProgress }).catch((error) => error.name);
    const { method } = await window.counterpart.match(a, b, { method: "nearest" });
    return [refused, method];
  });
  assert.deepEqual(outcome, ["Canceled", "nearest"]);
});
