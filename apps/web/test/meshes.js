// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Meshes that the tests drop.
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const folder = mkdtempSync(join(tmpdir(), "counterpart_page_"));

export function write(name, content) {
  const file = join(folder, name);
  writeFileSync(file, content);
  return file;
}

function permutation(n) {
  const items = Uint32Array.from({ length: n }, (_, i) => i);
  let state = 12345;
  for (let i = n - 1; i > 0; i--) {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    const j = state % (i + 1);
    [items[i], items[j]] = [items[j], items[i]];
  }
  return items;
}

/** A binary PLY file of a torus with colors, whose squares are cut one way or the other without a pattern: nothing but
 * the true map fits. Vertex i has the number order[i]. */
function torus(rings, segments, order, bend) {
  const count = rings * segments;
  const header = Buffer.from(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${count}\n` +
      "property float x\nproperty float y\nproperty float z\n" +
      "property uchar red\nproperty uchar green\nproperty uchar blue\n" +
      `element face ${2 * count}\nproperty list uchar int vertex_indices\nend_header\n`,
  );
  const body = Buffer.alloc(count * 15 + 2 * count * 13);
  for (let i = 0; i < rings; i++) {
    for (let j = 0; j < segments; j++) {
      const [u, v] = [(2 * Math.PI * i) / rings, (2 * Math.PI * j) / segments];
      const radius = 1 + (0.35 + 0.1 * Math.sin(u)) * Math.cos(v);
      const [x, y, z] = [radius * Math.cos(u), radius * Math.sin(u), 0.35 * Math.sin(v)];
      const at = 15 * order[i * segments + j];
      body.writeFloatLE(x, at);
      body.writeFloatLE(y + bend * x * x, at + 4);
      body.writeFloatLE(z + bend * Math.sin(2 * x), at + 8);
      body.set([(255 * i) / rings, (255 * j) / segments, 90], at + 12);
      const vertex = (a, b) => order[((i + a) % rings) * segments + ((j + b) % segments)];
      const square = [vertex(0, 0), vertex(1, 0), vertex(1, 1), vertex(0, 1)];
      if ((Math.imul(i * segments + j + 1, 2654435761) >>> 16) & 1) square.push(square.shift());
      const [a, b, c, d] = square;
      for (const [k, corners] of [[a, b, c], [a, c, d]].entries()) {
        const face = 15 * count + 13 * (2 * (i * segments + j) + k);
        body[face] = 3;
        corners.forEach((corner, c) => body.writeInt32LE(corner, face + 1 + 4 * c));
      }
    }
  }
  return Buffer.concat([header, body]);
}

/** A torus and a bent, renumbered copy of it, with the true map. */
export function writePair(rings, segments, name = "torus") {
  const truth = permutation(rings * segments);
  const source = write(`${name}.ply`, torus(rings, segments, Uint32Array.from(truth, (_, i) => i), 0));
  const target = write(`${name}_bent.ply`, torus(rings, segments, truth, 0.2));
  return { source, target, truth };
}
