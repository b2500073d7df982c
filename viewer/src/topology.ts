// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { MeshData } from "./scene_data";

/** The triangles around each vertex, in compressed rows, and what follows from them. */
export class Topology {
  readonly first: Uint32Array;
  readonly incident: Uint32Array;

  constructor(readonly mesh: MeshData) {
    const { triangles, vertexCount } = mesh;
    this.first = new Uint32Array(vertexCount + 1);
    for (let i = 0; i < triangles.length; i++) this.first[triangles[i] + 1]++;
    for (let v = 0; v < vertexCount; v++) this.first[v + 1] += this.first[v];
    this.incident = new Uint32Array(triangles.length);
    const next = this.first.slice(0, vertexCount);
    for (let i = 0; i < triangles.length; i++) this.incident[next[triangles[i]]++] = (i / 3) | 0;
  }

  /** Calls `visit` for each corner of the triangles around a vertex; neighbors come more than once. */
  forEachNeighbor(vertex: number, visit: (neighbor: number) => void): void {
    const { triangles } = this.mesh;
    for (let i = this.first[vertex]; i < this.first[vertex + 1]; i++) {
      const t = 3 * this.incident[i];
      for (let corner = t; corner < t + 3; corner++) if (triangles[corner] !== vertex) visit(triangles[corner]);
    }
  }

  /** Number of edges to each vertex from `base`, -1 where no path leads: the frontier that the vertex is on. */
  levels(base: number): Int32Array {
    const level = new Int32Array(this.mesh.vertexCount).fill(-1);
    const queue = new Uint32Array(this.mesh.vertexCount);
    let end = 1;
    queue[0] = base;
    level[base] = 0;
    for (let head = 0; head < end; head++) {
      const v = queue[head];
      this.forEachNeighbor(v, (n) => {
        if (level[n] >= 0) return;
        level[n] = level[v] + 1;
        queue[end++] = n;
      });
    }
    return level;
  }

  /** A vertex at an end of the largest component, found by two searches. */
  extremity(): number {
    let best = 0;
    let bestLevel = -1;
    this.levels(this.largestComponentStart()).forEach((level, v) => {
      if (level > bestLevel) [best, bestLevel] = [v, level];
    });
    return best;
  }

  /** A vertex of the component with the most vertices. */
  private largestComponentStart(): number {
    const { triangles, vertexCount } = this.mesh;
    const seen = new Uint8Array(vertexCount);
    let best = triangles[0];
    let most = 0;
    for (let i = 0; i < triangles.length; i += 3) {
      if (seen[triangles[i]]) continue;
      const queue = [triangles[i]];
      seen[triangles[i]] = 1;
      for (let head = 0; head < queue.length; head++) {
        this.forEachNeighbor(queue[head], (n) => {
          if (seen[n]) return;
          seen[n] = 1;
          queue.push(n);
        });
      }
      if (queue.length > most) [best, most] = [triangles[i], queue.length];
    }
    return best;
  }

  /** Area-weighted unit normals, xyz per vertex. */
  normals(): Float32Array {
    const { positions: p, triangles } = this.mesh;
    const normals = new Float32Array(p.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
      for (const corner of [a, b, c]) {
        normals[corner] += nx;
        normals[corner + 1] += ny;
        normals[corner + 2] += nz;
      }
    }
    for (let i = 0; i < normals.length; i += 3) {
      const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
      for (let k = 0; k < 3; k++) normals[i + k] /= length;
    }
    return normals;
  }
}
