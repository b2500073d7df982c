// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { MeshData } from "./scene_data";

/** Vertices spread over the mesh, far ones first (farthest-point sampling among at most 4000 candidates): any number
 * of them from the start of the list is spread out too. */
export function sampleVertices(mesh: MeshData, count: number): number[] {
  const step = Math.max(1, Math.ceil(mesh.vertexCount / 4000));
  const candidates: number[] = [];
  for (let v = 0; v < mesh.vertexCount; v += step) candidates.push(v);
  const distance = new Float32Array(candidates.length).fill(Infinity);
  const chosen: number[] = [];
  let next = 0;
  while (chosen.length < Math.min(count, candidates.length)) {
    const from = 3 * candidates[next];
    chosen.push(candidates[next]);
    distance[next] = -1;
    for (let i = 0; i < candidates.length; i++) {
      const at = 3 * candidates[i];
      let d = 0;
      for (let k = 0; k < 3; k++) d += (mesh.positions[at + k] - mesh.positions[from + k]) ** 2;
      if (d < distance[i]) distance[i] = d;
    }
    for (let i = 0; i < candidates.length; i++) if (distance[i] > distance[next]) next = i;
  }
  return chosen;
}
