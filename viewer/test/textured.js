// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Meshes with a look of their own, and one with parts that are alike.
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { deflateSync } from "node:zlib";

function crc32(bytes) {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let k = 0; k < 8; k++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

function png(width, height, rgb) {
  const chunk = (name, data) => {
    const body = Buffer.concat([Buffer.from(name), data]);
    const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(crc32(body));
    return Buffer.concat([length, body, sum]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const row = (y) => Buffer.from([0, ...Array.from({ length: width }, () => rgb(y)).flat()]);
  const rows = Buffer.concat(Array.from({ length: height }, (_, y) => row(y)));
  const chunks = [chunk("IHDR", header), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))];
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), ...chunks]);
}

/** source.obj: a sheet of 8 x 9 vertices with an image, red above blue; target.ply: the same sheet, green. */
export function writeTextured() {
  const folder = mkdtempSync(join(tmpdir(), "counterpart_textured_"));
  const [columns, rows] = [8, 9];
  const vertices = [];
  const triangles = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) vertices.push([i / (columns - 1), j / (rows - 1)]);
  for (let j = 0; j + 1 < rows; j++)
    for (let i = 0; i + 1 < columns; i++) {
      const v = j * columns + i;
      triangles.push([v, v + 1, v + columns + 1], [v, v + columns + 1, v + columns]);
    }
  const write = (name, content) => writeFileSync(join(folder, name), content);
  write("source.obj", [
    "mtllib source.mtl",
    ...vertices.map(([x, y]) => `v ${x} ${y} ${0.1 * x * x}`),
    ...vertices.map(([x, y]) => `vt ${x} ${y}`),
    "usemtl cloth",
    ...triangles.map((t) => `f ${t.map((v) => `${v + 1}/${v + 1}`).join(" ")}`),
  ].join("\n") + "\n");
  write("source.mtl", "newmtl cloth\nmap_Kd cloth.png\n");
  write("cloth.png", png(4, 4, (y) => (y < 2 ? [230, 20, 20] : [20, 20, 230])));
  write("target.ply", [
    "ply",
    "format ascii 1.0",
    `element vertex ${vertices.length}`,
    ...["x", "y", "z"].map((k) => `property float ${k}`),
    ...["red", "green", "blue"].map((k) => `property uchar ${k}`),
    `element face ${triangles.length}`,
    "property list uchar int vertex_indices",
    "end_header",
    ...vertices.map(([x, y]) => `${x} ${y} ${0.3 * x * y} 20 230 20`),
    ...triangles.map((t) => `3 ${t.join(" ")}`),
  ].join("\n") + "\n");
  return folder;
}

/** Four tetrahedra in a row, alike; the target is bent. */
export function writeTeeth() {
  const folder = mkdtempSync(join(tmpdir(), "counterpart_teeth_"));
  const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const faces = [[1, 3, 2], [1, 2, 4], [2, 3, 4], [1, 4, 3]];
  const write = (name, bend) => {
    const lines = [];
    for (const [shift, size] of [[0, 1], [2, 0.3], [3, 0.3], [4, 0.3]])
      for (const [x, y, z] of corners) {
        const along = shift + size * x;
        lines.push(`v ${along} ${size * y + bend * along ** 2} ${size * z}`);
      }
    for (let part = 0; part < 4; part++) for (const face of faces) lines.push(`f ${face.map((v) => 4 * part + v).join(" ")}`);
    writeFileSync(join(folder, name), lines.join("\n") + "\n");
  };
  write("source.obj", 0);
  write("target.obj", 0.02);
  return folder;
}
