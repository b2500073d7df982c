// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { type Quaternion, Vector3 } from "three";
import { type Field, fill } from "./field";
import type { Surface } from "./surface";

/**
 * Positions and normals of the images of the source's vertices, turned into the source's frame; unmatched vertices
 * follow their neighbors.
 */
export function morphGoal(
  source: Surface,
  target: Surface,
  image: Int32Array,
  sourceFromTarget: Quaternion,
): [Float32Array, Float32Array] {
  const gather = (values: Float32Array): Float32Array => {
    const field: Field = new Float32Array(4 * image.length);
    const value = new Vector3();
    image.forEach((to, v) => {
      if (to < 0) return;
      value.fromArray(values, 3 * to).applyQuaternion(sourceFromTarget).toArray(field, 4 * v);
      field[4 * v + 3] = 1;
    });
    fill(field, source.topology, Infinity);
    return Float32Array.from({ length: 3 * image.length }, (_, i) => field[4 * Math.floor(i / 3) + (i % 3)]);
  };
  return [gather(target.data.positions), gather(target.normals)];
}
