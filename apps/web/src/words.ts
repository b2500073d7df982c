// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { MatchResult } from "counterpart3d";

const count = (n: number) => n.toLocaleString("en-US");

export function sizeOf(mesh: { vertices: Float64Array; triangles: Int32Array }): string {
  return `${count(mesh.vertices.length / 3)} vertices, ${count(mesh.triangles.length / 3)} triangles`;
}

export function summaryOf(result: MatchResult, seconds: number): string {
  const vertices = `${count(result.nMatched)} of ${count(result.targetFromSource.length)} vertices`;
  const matched = `Matched ${vertices} by ${result.method} in ${seconds.toFixed(seconds < 10 ? 2 : 0)} s`;
  return result.reason ? `${matched}, because ${result.reason}.` : `${matched}.`;
}

/** How long the rest takes if it goes on like this; empty while it is too early to tell. */
export function timeLeft(fraction: number, seconds: number): string {
  if (fraction < 0.05 || seconds < 1) return "";
  const left = (seconds * (1 - fraction)) / fraction;
  return left < 60 ? `about ${Math.max(1, Math.round(left))} s left` : `about ${Math.round(left / 60)} min left`;
}
