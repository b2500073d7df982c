// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { rangeOf } from "./field";
import type { MapData, SceneData } from "./scene_data";

/** Numbers to color by. */
export interface Values {
  name: string;
  /** The ends of the scale. */
  range: [number, number];
  /** Per source vertex, as the page shows them with a map; null where they are not known of it. */
  of(map: MapData): Float32Array | null;
}

/** The ends of the scale: of shares, such as a confidence, 0 and 1, so that a map that is sure all over looks so. */
function scaleOf(values: Float32Array): [number, number] {
  const [low, high] = rangeOf(values);
  return low >= 0 && high > 0.5 && high <= 1 ? [0, 1] : [low, high];
}

/** The confidence of whichever map is shown, then what was given for the source whatever the map. */
export function valuesOf(scene: SceneData): Values[] {
  const given = scene.values.map(({ name, values }) => ({ name, range: scaleOf(values), of: () => values }));
  const confidence: Values = { name: "Confidence", range: [0, 1], of: (map) => map.confidence };
  return scene.maps.some((map) => map.confidence) ? [confidence, ...given] : given;
}
