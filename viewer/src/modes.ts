// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
/** What the meshes are coloured by; the order is the shader's. */
export const modes = ["colours", "checker", "error", "frontiers", "plain"] as const;
export type Mode = (typeof modes)[number];

export const modeLabels: Record<Mode, string> = {
  colours: "Colours",
  checker: "Checker",
  error: "Error",
  frontiers: "Frontiers",
  plain: "Plain",
};

export const modeTitles: Record<Mode, string> = {
  colours: "Each source vertex has a colour by its position; its counterpart has the same",
  checker: "A checker pattern on the source, carried to the target by the map",
  error: "Geodesic distance between where the map leads and the truth",
  frontiers: "Bands of equal edge distance from a source vertex, carried by the map; select a vertex to start there",
  plain: "Shape only",
};

export type Side = "source" | "target";
export interface Selection {
  side: Side;
  vertex: number;
}
