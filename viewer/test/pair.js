// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// A torus, and a bent and shuffled copy of it with the true map: what the tests look at.
import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const program =
  process.env.COUNTERPART ?? join(fileURLToPath(new URL(".", import.meta.url)), "../../build/release/counterpart");

/** A shuffled list 0 .. n - 1, always the same. */
function permutation(n) {
  const items = Array.from({ length: n }, (_, i) => i);
  let state = 12345;
  for (let i = n - 1; i > 0; i--) {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    const j = state % (i + 1);
    [items[i], items[j]] = [items[j], items[i]];
  }
  return items;
}

function obj(vertices, triangles) {
  const lines = vertices.map((p) => `v ${p.map((x) => x.toFixed(6)).join(" ")}`);
  return [...lines, ...triangles.map((t) => `f ${t.map((v) => v + 1).join(" ")}`)].join("\n") + "\n";
}

/** Writes source.obj, target.obj, truth.txt and worse.txt (every seventh vertex goes elsewhere, every fiftieth
 * nowhere) into a new folder. */
export function writePair(rings, segments) {
  const folder = mkdtempSync(join(tmpdir(), "counterpart_viewer_"));
  const vertices = [];
  const triangles = [];
  for (let i = 0; i < rings; i++) {
    for (let j = 0; j < segments; j++) {
      const [u, v] = [(2 * Math.PI * i) / rings, (2 * Math.PI * j) / segments];
      const radius = 1 + (0.35 + 0.1 * Math.sin(u)) * Math.cos(v);
      vertices.push([radius * Math.cos(u), radius * Math.sin(u), 0.35 * Math.sin(v)]);
      const at = (a, b) => ((i + a) % rings) * segments + ((j + b) % segments);
      triangles.push([at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]);
    }
  }
  const truth = permutation(vertices.length);
  const bent = [];
  vertices.forEach(([x, y, z], v) => {
    bent[truth[v]] = [1.3 * x, y + 0.25 * x * x, z + 0.2 * Math.sin(2 * x)];
  });
  const worse = truth.map((image, v) => (v % 50 === 3 ? -1 : v % 7 === 0 ? truth[(v + 5) % truth.length] : image));
  const write = (name, text) => writeFileSync(join(folder, name), text);
  write("source.obj", obj(vertices, triangles));
  write("target.obj", obj(bent, triangles.map((t) => t.map((v) => truth[v])).reverse()));
  write("truth.txt", truth.join("\n") + "\n");
  write("worse.txt", worse.join("\n") + "\n");
  return { folder, truth, worse, count: vertices.length };
}

/** Runs `counterpart view` on such a folder; returns the page's path. */
export function writePage({ folder }, maps, ...options) {
  const page = join(folder, "view.html");
  const mapOptions = maps.flatMap((map) => ["--map", join(folder, map)]);
  const meshes = [join(folder, "source.obj"), join(folder, "target.obj")];
  execFileSync(program, ["view", ...meshes, ...mapOptions, "-q", "-o", page, ...options]);
  return page;
}
