// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { element } from "./panel";
import type { SceneData } from "./scene_data";
import type { Stage } from "./stage";

/** The names of the meshes, in the corner of their panes, and of the maps where several are seen at once. */
export class Names {
  constructor(private readonly scene: SceneData) {
    for (const side of ["source", "target"] as const) {
      const { name, vertexCount, triangleCount } = scene[side];
      const title = document.createElement("b");
      title.textContent = name;
      const size = document.createElement("span");
      size.className = "size";
      size.textContent = ` · ${vertexCount.toLocaleString("en")} vertices, ${triangleCount.toLocaleString("en")} triangles`;
      const role = name === side ? "" : ` · ${side}`;
      element(`${side}-name`).replaceChildren(title, role, size);
    }
    const title = `${scene.source.name} → ${scene.target.name}`;
    element("title").textContent = title;
    document.title = `${title} · counterpart`;
  }

  /** Each names the pane of the target that it colors, from left to right, row by row. */
  showMaps(maps: number[]): void {
    const names = maps.map((map) => {
      const name = document.createElement("div");
      name.className = "pane-name";
      name.textContent = this.scene.maps[map].name;
      return name;
    });
    element("map-names").replaceChildren(...names);
  }

  place(stage: Stage): void {
    const place = (name: HTMLElement, pane: number, down: number) => {
      const { left, top, width } = stage.rectangle(pane);
      Object.assign(name.style, { left: `${left + 10}px`, top: `${top + down}px`, maxWidth: `${width - 20}px` });
    };
    place(element("source-name"), 0, 8);
    place(element("target-name"), 1, 8);
    // Below the target's name in its first pane.
    [...element("map-names").children].forEach((name, i) => place(name as HTMLElement, i + 1, i === 0 ? 38 : 8));
  }
}
