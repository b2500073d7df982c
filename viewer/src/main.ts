// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import "./style.css";
import { App } from "./app";
import { element } from "./panel";
import { readScene } from "./scene_data";

try {
  // For scripts and tests: the page's state and where vertices are on the screen.
  Object.assign(window, { counterpart: new App(readScene()) });
} catch (error) {
  const message = element("message");
  const noGraphics = /WebGL/.test(String(error)) ? " This page needs WebGL 2." : "";
  message.textContent = (error instanceof Error ? error.message : String(error)) + noGraphics;
  message.hidden = false;
}
