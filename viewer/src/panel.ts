// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { type Mode, modeLabels, modes, modeTitles } from "./modes";
import type { SceneData } from "./scene_data";
import type { Values } from "./values";

export interface PanelEvents {
  mode(mode: Mode): void;
  map(index: number): void;
  lines(count: number): void;
  morph(amount: number): void;
  linked(linked: boolean): void;
  reset(): void;
  vertex(vertex: number): void;
  values(index: number): void;
  /** The error at the end of the scale; null = automatic. */
  scale(top: number | null): void;
  picking(picking: boolean): void;
  saveLandmarks(): void;
  clearLandmarks(): void;
  /** All maps at once, or only the current one. */
  comparing(comparing: boolean): void;
}

export function element<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

/** The controls around the stage. */
export class Panel {
  private readonly vertex = element<HTMLInputElement>("vertex");
  private isTyping = false;

  constructor(scene: SceneData, values: Values[], initial: Mode, events: PanelEvents) {
    this.addModes(scene, values, initial, events);
    this.addMaps(scene, events);
    this.addSlider("lines", String, events.lines);
    this.addSlider("morph", (value) => `${value} %`, (value) => events.morph(value / 100));
    const linked = element<HTMLInputElement>("linked");
    linked.addEventListener("change", () => events.linked(linked.checked));
    element("reset").addEventListener("click", () => events.reset());
    element("controls").addEventListener("submit", (event) => event.preventDefault());
    this.vertex.max = String(scene.source.vertexCount - 1);
    this.addValues(values, events);
    const scale = element<HTMLInputElement>("scale");
    element("scale-field").hidden = !scene.maps.some((map) => map.error);
    scale.addEventListener("input", () => events.scale(Number(scale.value) > 0 ? Number(scale.value) : null));
    const picking = element<HTMLInputElement>("picking");
    picking.addEventListener("change", () => events.picking(picking.checked));
    element("save-landmarks").addEventListener("click", () => events.saveLandmarks());
    element("clear-landmarks").addEventListener("click", () => events.clearLandmarks());
    this.vertex.addEventListener("input", () => {
      this.isTyping = true;
      if (this.vertex.value !== "" && this.vertex.checkValidity()) events.vertex(Number(this.vertex.value));
    });
  }

  /** What is pointed at counts again, not what was typed. */
  pointed(): void {
    this.isTyping = false;
  }

  showLandmarks(count: number, waiting: string): void {
    element("landmarks").textContent = waiting || `${count} ${count === 1 ? "pair" : "pairs"}`;
    for (const id of ["save-landmarks", "clear-landmarks"])
      element<HTMLButtonElement>(id).disabled = count === 0;
  }

  /** Fills in the number of the selected source vertex, unless someone is typing there. */
  showVertex(vertex: number | null): void {
    if (document.activeElement !== this.vertex || !this.isTyping) this.vertex.value = vertex === null ? "" : String(vertex);
  }

  /** What may be wrong with the map that is shown: a sentence, or their number with a list to open. */
  showWarnings(warnings: string[]): void {
    const list = element("warnings");
    list.hidden = warnings.length === 0;
    if (list.dataset.shown === warnings.join("\n")) return; // and may be open
    list.dataset.shown = warnings.join("\n");
    const items = warnings.map((warning) => {
      const item = document.createElement("li");
      item.textContent = warning;
      return item;
    });
    element("warning-count").textContent = `${warnings.length} ${warnings.length === 1 ? "warning" : "warnings"}`;
    element("warning-list").replaceChildren(...items);
  }

  private addModes(scene: SceneData, values: Values[], initial: Mode, events: PanelEvents): void {
    const hasError = scene.maps.some((map) => map.error);
    for (const mode of modes) {
      const label = document.createElement("label");
      const input = document.createElement("input");
      Object.assign(input, { type: "radio", name: "mode", value: mode, checked: mode === initial });
      if (mode === "values" && values.length === 0) continue;
      if (mode === "texture" && !scene.source.appearance && !scene.target.appearance) continue;
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
    const comparing = element<HTMLInputElement>("comparing");
    comparing.addEventListener("change", () => events.comparing(comparing.checked));
    for (const id of ["map-field", "comparing-field"]) element(id).hidden = scene.maps.length < 2;
  }

  private addValues(values: Values[], events: PanelEvents): void {
    const select = element<HTMLSelectElement>("values");
    values.forEach(({ name }, index) => select.add(new Option(name, String(index))));
    select.addEventListener("change", () => events.values(Number(select.value)));
    element("values-field").hidden = values.length < 2;
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
