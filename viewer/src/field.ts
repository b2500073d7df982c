// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// A field colors a mesh: four numbers per vertex, a value of up to three numbers and whether it is known (1) or not
// (0).
import type { Topology } from "./topology";

export type Field = Float32Array;

/** Vertices that are not images take the mean of their neighbors, up to this many edges away. */
export const fillRings = 3;

/** Gives unknown vertices the mean of known neighbors, ring after ring. */
export function fill(field: Field, topology: Topology, rings: number): void {
  let unknown: number[] = [];
  for (let v = 0; v < field.length / 4; v++) if (field[4 * v + 3] === 0) unknown.push(v);
  for (let ring = 0; ring < rings && unknown.length > 0; ring++) {
    const found: number[] = [];
    const rest: number[] = [];
    const sums: number[] = [];
    for (const v of unknown) {
      let x = 0, y = 0, z = 0, n = 0;
      topology.forEachNeighbor(v, (w) => {
        if (field[4 * w + 3] === 0) return;
        x += field[4 * w];
        y += field[4 * w + 1];
        z += field[4 * w + 2];
        n++;
      });
      if (n > 0) {
        found.push(v);
        sums.push(x / n, y / n, z / n);
      } else {
        rest.push(v);
      }
    }
    if (found.length === 0) return;
    found.forEach((v, i) => field.set([sums[3 * i], sums[3 * i + 1], sums[3 * i + 2], 1], 4 * v));
    unknown = rest;
  }
}

/** The source's field transferred to the target: the mean over the source vertices that map to each vertex. */
export function carry(field: Field, image: Int32Array, target: Topology): Field {
  const carried = new Float32Array(4 * target.mesh.vertexCount);
  for (let v = 0; v < image.length; v++) {
    if (image[v] < 0 || field[4 * v + 3] === 0) continue;
    const to = 4 * image[v];
    for (let k = 0; k < 4; k++) carried[to + k] += field[4 * v + k];
  }
  for (let i = 0; i < carried.length; i += 4) {
    const n = carried[i + 3];
    if (n > 0) for (let k = 0; k < 4; k++) carried[i + k] /= n;
  }
  fill(carried, target, fillRings);
  return carried;
}

/** Positions scaled to 0 .. 1 along each axis; unknown for unmatched vertices. */
export function positionField(positions: Float32Array, image: Int32Array): Field {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const field = new Float32Array(4 * image.length);
  for (let v = 0; v < image.length; v++) {
    for (let k = 0; k < 3; k++)
      field[4 * v + k] = (positions[3 * v + k] - low[k]) / (high[k] - low[k] || 1);
    field[4 * v + 3] = image[v] < 0 ? 0 : 1;
  }
  return field;
}

/** One number per vertex; `known` says which. Infinite values stay finite for the graphics card. */
export function scalarField(values: ArrayLike<number>, known: (vertex: number) => boolean): Field {
  const field = new Float32Array(4 * values.length);
  for (let v = 0; v < values.length; v++)
    if (known(v)) field.set([Math.min(values[v], 1e6), 0, 0, 1], 4 * v);
  return field;
}

/** The least and the largest of the finite values. */
export function rangeOf(values: Float32Array): [number, number] {
  const known = values.filter(Number.isFinite);
  return [known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), -Infinity)];
}
