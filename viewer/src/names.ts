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

  /** Each names the pane of the target that it colors, from left to right, row by row; none: the target's own name. */
  showMaps(maps: number[]): void {
    const names = maps.map((map) => {
      const name = document.createElement("div");
      name.className = "pane-name";
      name.textContent = this.scene.maps[map].name;
      return name;
    });
    element("map-names").replaceChildren(...names);
    element("target-name").hidden = names.length > 0;
  }

  /** Puts the names above the meshes, for which they leave the rest of the panes. */
  place(stage: Stage): void {
    const maps = [...element("map-names").children] as HTMLElement[];
    const names = [element("source-name"), ...(maps.length > 0 ? maps : [element("target-name")])];
    const margin = 8;
    // How wide a pane is may depend on the height of the names: the second time it does not any more.
    for (let round = 0; round < 2; round++) {
      names.forEach((name, pane) => {
        const { left, top, width } = stage.cell(pane);
        Object.assign(name.style, { left: `${left + 10}px`, top: `${top + margin}px`, maxWidth: `${width - 20}px` });
      });
      stage.setCaptionHeight(margin + Math.max(...names.map((name) => name.offsetHeight)));
    }
  }
}
