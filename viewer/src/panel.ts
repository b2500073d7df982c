// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { type Mode, modeLabels, modes, modeTitles } from "./modes";
import type { SceneData } from "./scene_data";

export interface PanelEvents {
  mode(mode: Mode): void;
  map(index: number): void;
  lines(count: number): void;
  morph(amount: number): void;
  linked(linked: boolean): void;
  reset(): void;
  vertex(vertex: number): void;
}

export function element<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

/** The controls around the stage. */
export class Panel {
  private readonly vertex = element<HTMLInputElement>("vertex");

  constructor(scene: SceneData, initial: Mode, events: PanelEvents) {
    this.addModes(scene, initial, events);
    this.addMaps(scene, events);
    this.addSlider("lines", String, events.lines);
    this.addSlider("morph", (value) => `${value} %`, (value) => events.morph(value / 100));
    const linked = element<HTMLInputElement>("linked");
    linked.addEventListener("change", () => events.linked(linked.checked));
    element("reset").addEventListener("click", () => events.reset());
    element("controls").addEventListener("submit", (event) => event.preventDefault());
    this.vertex.max = String(scene.source.vertexCount - 1);
    this.vertex.addEventListener("input", () => {
      if (this.vertex.value !== "" && this.vertex.checkValidity()) events.vertex(Number(this.vertex.value));
    });
  }

  /** Fills in the number of the selected source vertex, unless someone is typing there. */
  showVertex(vertex: number | null): void {
    if (document.activeElement !== this.vertex) this.vertex.value = vertex === null ? "" : String(vertex);
  }

  private addModes(scene: SceneData, initial: Mode, events: PanelEvents): void {
    const hasError = scene.maps.some((map) => map.error);
    for (const mode of modes) {
      const label = document.createElement("label");
      const input = document.createElement("input");
      Object.assign(input, { type: "radio", name: "mode", value: mode, checked: mode === initial });
      input.disabled = mode === "error" && !hasError;
      input.addEventListener("change", () => events.mode(mode));
      label.title = input.disabled ? "Needs the true map: counterpart view --truth" : modeTitles[mode];
      label.append(input, modeLabels[mode]);
      element("modes").append(label);
    }
  }

  private addMaps(scene: SceneData, events: PanelEvents): void {
    const select = element<HTMLSelectElement>("map");
    scene.maps.forEach((map, index) => select.add(new Option(map.name, String(index))));
    select.addEventListener("change", () => events.map(Number(select.value)));
    element("map-field").hidden = scene.maps.length < 2;
  }

  private addSlider(id: string, format: (value: number) => string, changed: (value: number) => void): void {
    const slider = element<HTMLInputElement>(id);
    const value = element<HTMLOutputElement>(`${id}-value`);
    const show = () => {
      value.textContent = format(Number(slider.value));
    };
    slider.addEventListener("input", () => {
      show();
      changed(Number(slider.value));
    });
    show();
  }
}
