// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// A bar of two joints with three morph targets and a texture, as a GLB that the program reads.
import { writeFileSync } from "node:fs";

const rings = 9;
const sides = 8;

// A white dot.
const png =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/5+hHgAHggJ/PchI7wAAAABJRU5ErkJggg==";

/** The vertices of the tube (split along the texture's seam, closed by two caps of their own vertex) and its triangles. */
function bar() {
  const positions = [];
  const uvs = [];
  for (let ring = 0; ring < rings; ring++) {
    for (let side = 0; side <= sides; side++) {
      const angle = (2 * Math.PI * (side % sides)) / sides;
      positions.push([0.3 * Math.cos(angle), ring / (rings - 1) + 0.01 * (side % sides), 0.2 * Math.sin(angle)]);
      uvs.push([side / sides, ring / (rings - 1)]);
    }
  }
  positions.push([0, -0.1, 0], [0, 1.1, 0.05]);
  uvs.push([0.5, 0], [0.5, 1]);
  const triangles = [];
  const at = (ring, side) => ring * (sides + 1) + side;
  for (let side = 0; side < sides; side++) {
    for (let ring = 0; ring + 1 < rings; ring++) {
      const [a, b, c, d] = [at(ring, side), at(ring, side + 1), at(ring + 1, side), at(ring + 1, side + 1)];
      triangles.push([a, c, b], [b, c, d]);
    }
    triangles.push([rings * (sides + 1), at(0, side), at(0, side + 1)]);
    triangles.push([rings * (sides + 1) + 1, at(rings - 1, side + 1), at(rings - 1, side)]);
  }
  return { positions, uvs, triangles };
}

/** Writes the GLB. */
export function writeCharacter(file) {
  const { positions, uvs, triangles } = bar();
  const json = { asset: { version: "2.0" }, scene: 0, accessors: [], bufferViews: [] };
  const chunks = [];
  let size = 0;
  const add = (rows, Type, componentType, type, bounds) => {
    const bytes = Buffer.from(new Type(rows.flat()).buffer);
    json.bufferViews.push({ buffer: 0, byteOffset: size, byteLength: bytes.length });
    const column = (k) => rows.map((row) => Math.fround(row[k]));
    const limits = bounds
      ? { min: [0, 1, 2].map((k) => Math.min(...column(k))), max: [0, 1, 2].map((k) => Math.max(...column(k))) }
      : {};
    json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType, type, count: rows.length, ...limits });
    chunks.push(bytes);
    size += bytes.length;
    return json.accessors.length - 1;
  };
  const floats = (rows, type, bounds = false) => add(rows, Float32Array, 5126, type, bounds);
  const height = positions.map((p) => Math.min(1, Math.max(0, p[1])));
  const attributes = {
    POSITION: floats(positions, "VEC3", true),
    TEXCOORD_0: floats(uvs, "VEC2"),
    JOINTS_0: add(positions.map(() => [0, 1, 0, 0]), Uint8Array, 5121, "VEC4"),
    WEIGHTS_0: floats(height.map((h) => [1 - h, h, 0, 0]), "VEC4"),
  };
  const targets = [
    positions.map((p) => [0.5 * p[0], 0, 0.5 * p[2]]),
    height.map((h) => [0, 0.25 * h, 0]),
    height.map((h) => [0, 0, 0.1 * h * h]),
  ].map((rows) => ({ POSITION: floats(rows, "VEC3", true) }));
  const indices = add(triangles.flat().map((i) => [i]), Uint16Array, 5123, "SCALAR");
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const lowered = [...identity.slice(0, 13), -0.5, 0, 1];
  const inverseBindMatrices = floats([identity, lowered], "MAT4");
  const material = { name: "skin", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } };
  const node = { name: "bar", mesh: 0, skin: 0 };
  Object.assign(json, {
    scenes: [{ nodes: [0, 1] }],
    nodes: [node, { name: "root", children: [2] }, { name: "elbow", translation: [0, 0.5, 0] }],
    meshes: [{ primitives: [{ attributes, indices, targets, material: 0 }], extras: { targetNames: ["wide", "tall", "lean"] } }],
    skins: [{ joints: [1, 2], inverseBindMatrices }],
    materials: [material],
    textures: [{ source: 0 }],
    images: [{ uri: png }],
    buffers: [{ byteLength: size }],
  });
  const text = Buffer.from(JSON.stringify(json));
  const pad = (bytes, filler) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
  const chunk = (type, bytes) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0);
    head.write(type, 4, "latin1");
    return Buffer.concat([head, bytes]);
  };
  const body = Buffer.concat([chunk("JSON", pad(text, " ")), chunk("BIN\0", pad(Buffer.concat(chunks), 0))]);
  const head = Buffer.alloc(12);
  head.write("glTF", 0, "latin1");
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + body.length, 8);
  writeFileSync(file, Buffer.concat([head, body]));
}
