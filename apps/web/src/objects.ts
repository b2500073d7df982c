// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { MeshObject } from "counterpart3d";

/** What `readMesh` calls an object: its name, or its number if others have that name or it has none. */
function callOf(objects: readonly MeshObject[], i: number): string {
  const { name } = objects[i];
  return name !== "" && objects.filter((other) => other.name === name).length === 1 ? name : String(i);
}

/** Offers the objects of a file, and the file as a whole first; hides the choice where there is none. */
export function offerObjects(select: HTMLSelectElement, objects: readonly MeshObject[]): void {
  const options = objects.map(({ name, nTriangles }, i) => {
    const words = `${name || `number ${i}`}: ${nTriangles.toLocaleString("en-US")} triangles`;
    return new Option(words, callOf(objects, i));
  });
  select.replaceChildren(new Option(`all ${objects.length} objects`, ""), ...options);
  select.parentElement!.hidden = objects.length < 2;
}
