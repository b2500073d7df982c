// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The viewer, in the page's frame: the page hands it the scene.
import type { Pair } from "counterpart3d";
import "../../../viewer/src/style.css";
import { App } from "../../../viewer/src/app";
import { element } from "../../../viewer/src/panel";
import { sceneOf } from "../../../viewer/src/scene_data";

function show(description: string, arrays: Uint8Array, landmarks: readonly Pair[]): void {
  try {
    const app = new App(sceneOf(JSON.parse(description), arrays.slice().buffer));
    app.addLandmarks(landmarks);
    Object.assign(window, { counterpart: app });
  } catch (error) {
    const message = element("message");
    const noGraphics = /WebGL/.test(String(error)) ? " The view needs WebGL 2." : "";
    message.textContent = (error instanceof Error ? error.message : String(error)) + noGraphics;
    message.hidden = false;
  }
}

Object.assign(window, { show });
