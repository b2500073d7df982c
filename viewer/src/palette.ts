// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Colors shared by the shader and the legend, as #rrggbb from low to high.

/** RdYlBu of ColorBrewer, blue = no error: distinguishable with any color vision. */
export const errorStops = ["#2c7bb6", "#abd9e9", "#ffffbf", "#fdae61", "#d7191c"];
/** Viridis. */
export const levelStops = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"];
export const missingColor = "#8a8f98";
export const plainColor = "#c9ced6";

export function toRgb(hex: string): [number, number, number] {
  const n = parseInt(hex.slice(1), 16);
  return [(n >> 16) / 255, ((n >> 8) & 255) / 255, (n & 255) / 255];
}

/** The shader's color for a value of the position field, for markers and lines. */
export function positionColor(x: number, y: number, z: number): string {
  const channel = (value: number) => Math.round(255 * (0.12 + 0.83 * value));
  return `rgb(${channel(x)} ${channel(y)} ${channel(z)})`;
}

export function gradient(stops: string[]): string {
  return `linear-gradient(to right, ${stops.join(", ")})`;
}

/** Linear between the stops, as in the shader; `t` is clamped to 0 .. 1. */
export function interpolate(stops: string[], t: number): string {
  const s = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(s), stops.length - 2);
  const [a, b] = [toRgb(stops[i]), toRgb(stops[i + 1])];
  return `rgb(${a.map((low, k) => Math.round(255 * (low + (s - i) * (b[k] - low)))).join(" ")})`;
}
