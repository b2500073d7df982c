// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Pair, ViewerScene } from "counterpart3d";

interface Viewer extends Window {
  show(description: string, arrays: Uint8Array, landmarks: readonly Pair[]): void;
}

/** Loads the viewer's frame anew with this scene and the landmarks; `landmarked` is told the pairs once others are clicked. */
export async function showScene(
  frame: HTMLIFrameElement,
  scene: ViewerScene,
  landmarks: readonly Pair[],
  landmarked: (pairs: Pair[]) => void,
): Promise<void> {
  frame.hidden = false;
  await new Promise((loaded) => {
    frame.addEventListener("load", loaded, { once: true });
    frame.src = "viewer.html";
  });
  const viewer = frame.contentWindow as Viewer;
  viewer.addEventListener("landmarks", (event) => landmarked([...(event as CustomEvent<Pair[]>).detail]));
  viewer.show(scene.description, scene.arrays, landmarks);
}
