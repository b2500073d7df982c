// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// A mesh with everything that can be transferred.
import { readFileSync } from "node:fs";
import { write } from "./meshes.js";

const onePixel =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

/** Vertices and triangles of a PLY file of meshes.js. */
function read(file) {
  const bytes = readFileSync(file);
  const [, vertices, triangles] = /element vertex (\d+)[^]*element face (\d+)/.exec(bytes.toString("latin1")).map(Number);
  const body = bytes.subarray(bytes.indexOf("end_header\n") + "end_header\n".length);
  const positions = Array.from({ length: vertices }, (_, v) => [0, 4, 8].map((at) => body.readFloatLE(15 * v + at)));
  const corners = Array.from({ length: triangles }, (_, t) =>
    [1, 5, 9].map((at) => body.readInt32LE(15 * vertices + 13 * t + at)));
  return { positions, corners };
}

/** A glTF of such a mesh with colors, a texture, a skin of two joints and two morph targets. */
export function writeCharacter(name, file) {
  const { positions, corners } = read(file);
  const gltf = {
    asset: { version: "2.0" },
    scenes: [{ nodes: [0, 1] }],
    nodes: [
      { mesh: 0, skin: 0 },
      { name: "left", translation: [-1, 0, 0], children: [2] },
      { name: "right", translation: [2, 0, 0] },
    ],
    skins: [{ joints: [1, 2] }],
    images: [{ uri: onePixel }],
    textures: [{ source: 0 }],
    materials: [{ name: "skin", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    accessors: [],
    bufferViews: [],
  };
  const buffers = [];
  let length = 0;
  const add = (rows, Values, type, componentType) => {
    const bytes = Buffer.from(Values.from(rows.flat()).buffer);
    gltf.bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
    const bounds = type === "VEC3" && { min: extreme(rows, Math.min), max: extreme(rows, Math.max) };
    gltf.accessors.push({ bufferView: gltf.bufferViews.length - 1, componentType, count: rows.length, type, ...bounds });
    buffers.push(bytes);
    length += bytes.length;
    return gltf.accessors.length - 1;
  };
  const floats = (type, row) => add(positions.map(row), Float32Array, type, 5126);
  const extreme = (rows, choose) => [0, 1, 2].map((i) => rows.map((row) => row[i]).reduce((a, b) => choose(a, b)));
  const right = ([x]) => Math.fround(Math.min(1, Math.max(0, 0.5 + x / 3)));
  const attributes = {
    POSITION: floats("VEC3", (p) => p),
    TEXCOORD_0: floats("VEC2", ([x, y]) => [0.5 + x / 4, 0.5 + y / 4]),
    COLOR_0: floats("VEC4", ([x, y, z]) => [0.5 + x / 4, 0.5 + y / 4, 0.5 + z / 4, 1]),
    JOINTS_0: add(positions.map(() => [0, 1, 0, 0]), Uint8Array, "VEC4", 5121),
    WEIGHTS_0: floats("VEC4", (p) => [1 - right(p), right(p), 0, 0]),
  };
  const shapes = [floats("VEC3", ([, , z]) => [0, 0, z / 2]), floats("VEC3", ([x]) => [0, x * x, 0])];
  const targets = shapes.map((POSITION) => ({ POSITION }));
  const indices = add(corners.flat(), Uint32Array, "SCALAR", 5125);
  gltf.meshes = [{ primitives: [{ attributes, targets, indices, material: 0 }], extras: { targetNames: ["thick", "bent"] } }];
  const base64 = Buffer.concat(buffers).toString("base64");
  gltf.buffers = [{ byteLength: length, uri: `data:application/octet-stream;base64,${base64}` }];
  return write(name, JSON.stringify(gltf));
}
