// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The other end of RemoteCounterpart: runs one function after the other, in a worker.
import type { Mesh } from "./mesh.js";
import { type Counterpart, load, Mesh as HeldMesh } from "./index.js";
import type { MeshMessage, MeshNumber, Reply, Request } from "./messages.js";

const scope = self as unknown as {
  onmessage: ((event: MessageEvent) => void) | null;
  postMessage(message: Reply): void;
};
const meshes = new Map<number, Mesh>();
let nMeshes = 0;
let library: Promise<Counterpart>;

const isNumber = (value: unknown): value is MeshNumber => typeof value === "object" && value !== null && "meshNumber" in value;

function kept(mesh: Mesh): MeshMessage {
  meshes.set(++nMeshes, mesh);
  const { name, vertices, triangles, notices, attributes, objects } = mesh;
  return { meshNumber: nMeshes, name, vertices, triangles, notices, attributes, objects };
}

/** The value with messages in place of the meshes in it. */
function toMessage(value: unknown): unknown {
  if (value instanceof HeldMesh) return kept(value);
  if (Array.isArray(value)) return value.map(toMessage);
  if (typeof value === "object" && value !== null && "mesh" in value) return { ...value, mesh: toMessage(value.mesh) };
  return value;
}

async function answer({ id, call, arguments: given, reports }: Request): Promise<Reply> {
  const counterpart = await library;
  try {
    if (call === "free") {
      const number = given[0] as number;
      meshes.get(number)?.free();
      return { id, value: meshes.delete(number) };
    }
    const values = given.map((value) => (isNumber(value) ? meshes.get(value.meshNumber) : value));
    if (reports) {
      const onProgress = (progress: number) => scope.postMessage({ id, progress });
      values[values.length - 1] = { ...(values[values.length - 1] as object), onProgress };
    }
    const run = counterpart[call] as (...values: unknown[]) => unknown;
    return { id, value: toMessage(run.apply(counterpart, values)) };
  } catch (error) {
    const { name, message } = error instanceof Error ? error : { name: "Failure", message: String(error) };
    return { id, error: { kind: name, message } };
  }
}

scope.onmessage = ({ data }: MessageEvent<WebAssembly.Module | Request>) => {
  if (data instanceof WebAssembly.Module) library = load(data);
  else void answer(data).then((reply) => scope.postMessage(reply));
};
