// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { MapData, SceneData } from "./scene_data";

/** A map in both directions, with a one-line summary. */
export class Correspondence {
  private readonly first: Uint32Array;
  private readonly sources: Uint32Array;
  readonly matched: number;
  readonly covered: number;

  constructor(
    readonly map: MapData,
    private readonly scene: SceneData,
  ) {
    const targetCount = scene.target.vertexCount;
    this.first = new Uint32Array(targetCount + 1);
    for (const image of map.image) if (image >= 0) this.first[image + 1]++;
    let covered = 0;
    for (let t = 0; t < targetCount; t++) {
      if (this.first[t + 1] > 0) covered++;
      this.first[t + 1] += this.first[t];
    }
    this.covered = covered;
    this.matched = this.first[targetCount];
    this.sources = new Uint32Array(this.matched);
    const next = this.first.slice(0, targetCount);
    map.image.forEach((image, v) => {
      if (image >= 0) this.sources[next[image]++] = v;
    });
  }

  /** The source vertices that map to a target vertex, in increasing order. */
  sourcesOf(target: number): number[] {
    return Array.from(this.sources.subarray(this.first[target], this.first[target + 1]));
  }

  /** The 98th percentile of the known errors; 1 if all are 0 or none is known. */
  errorScale(): number {
    const known = (this.map.error ?? new Float32Array(0)).filter(Number.isFinite).sort();
    return known[Math.floor(0.98 * (known.length - 1))] || known[known.length - 1] || 1;
  }

  /** How much it matches, and how well as far as that is known. */
  summary(): string {
    const sourceCount = this.scene.source.vertexCount;
    const parts = [
      `${this.matched.toLocaleString("en")} of ${sourceCount.toLocaleString("en")} vertices matched`,
      `${((100 * this.covered) / this.scene.target.vertexCount).toFixed(1)} % of the target reached`,
    ];
    if (this.map.evaluation) parts.push(this.map.evaluation);
    return parts.join(" · ");
  }
}
