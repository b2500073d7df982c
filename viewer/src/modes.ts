// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
/** What the meshes are colored by; the order is the shader's. */
export const modes = ["colors", "checker", "error", "values", "frontiers", "plain", "texture"] as const;
export type Mode = (typeof modes)[number];

export const modeLabels: Record<Mode, string> = {
  colors: "Colors",
  checker: "Checker",
  error: "Error",
  values: "Values",
  frontiers: "Frontiers",
  plain: "Plain",
  texture: "Texture",
};

export const modeTitles: Record<Mode, string> = {
  colors: "Source vertices are colored by position; their images have the same color",
  checker: "A checkerboard on the source, transferred to the target by the map",
  error: "Geodesic distance between the image and the true image",
  values: "Numbers given for each source vertex, transferred by the map",
  frontiers: "Frontiers of a source vertex, transferred by the map; select a vertex to start there",
  plain: "Shape only",
  texture: "Each mesh with its own images and colors",
};

export type Side = "source" | "target";
export interface Selection {
  side: Side;
  vertex: number;
  /** The map that a vertex of the target is seen through; absent: the current one. */
  map?: number;
}
