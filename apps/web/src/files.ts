// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { RemoteCounterpart, RemoteMesh } from "counterpart3d/worker";

/** A mesh file, and those that it may name beside itself. */
export interface MeshFiles {
  mesh: File;
  beside: File[];
}

const ending = (file: File) => /\.[^.]+$/.exec(file.name)?.[0].toLowerCase() ?? "";

/** Whether a file holds the vertices of another one: a .node beside its .ele or .poly. */
function isNamedBy(file: File, others: File[]): boolean {
  const stem = file.name.slice(0, -".node".length);
  return ending(file) === ".node" && others.some(({ name }) => name === `${stem}.ele` || name === `${stem}.poly`);
}

/** The meshes among these files, each with all that are none. Without a mesh the first file is taken for one, so that reading it
 * says what is wrong. */
export function meshesAmong(files: File[], readable: readonly string[]): MeshFiles[] {
  const meshes = files.filter((file) => readable.includes(ending(file)) && !isNamedBy(file, files));
  const beside = files.filter((file) => !meshes.includes(file));
  if (meshes.length === 0 && beside.length > 0) meshes.push(beside.shift()!);
  return meshes.map((mesh) => ({ mesh, beside }));
}

async function bytesOf(file: File): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

/** `object`: of the file, or the whole if it is empty. */
export async function readFiles(library: RemoteCounterpart, { mesh, beside }: MeshFiles, object: string): Promise<RemoteMesh> {
  const others: Record<string, Uint8Array> = {};
  for (const file of beside) others[file.name] = await bytesOf(file);
  return library.readMesh(mesh.name, await bytesOf(mesh), { beside: others, ...(object !== "" && { object }) });
}

/** Hands a file to the person. */
export function save(name: string, content: string | Uint8Array): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content as BlobPart]));
  link.download = name;
  link.click();
  // The download begins after this turn.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Calls `take` with the files that are dropped on an element or chosen by its input. */
export function listenForFiles(zone: HTMLElement, input: HTMLInputElement, take: (files: File[]) => void): void {
  input.addEventListener("change", () => {
    if (input.files?.length) take([...input.files]);
    input.value = ""; // so that the same file can be chosen again
  });
  zone.addEventListener("dragover", (event) => {
    event.preventDefault();
    zone.classList.add("over");
  });
  zone.addEventListener("dragleave", () => zone.classList.remove("over"));
  zone.addEventListener("drop", (event) => {
    event.preventDefault();
    zone.classList.remove("over");
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length > 0) take(files);
  });
}
