// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What `RemoteCounterpart` and its worker say to each other.
import type { MeshObject } from "./types.js";

/** Functions of Counterpart that a worker runs. */
export type Call =
  | "extensions"
  | "readMesh"
  | "makeMesh"
  | "writeMesh"
  | "match"
  | "reorder"
  | "transfer"
  | "evaluate"
  | "viewerScene"
  | "example";

/** Stands for a mesh that the worker holds. */
export interface MeshNumber {
  meshNumber: number;
}

export interface MeshMessage extends MeshNumber {
  name: string;
  vertices: Float64Array;
  triangles: Int32Array;
  notices: readonly string[];
  attributes: readonly string[];
  objects: readonly MeshObject[];
}

export interface Request {
  id: number;
  call: Call | "free";
  /** Meshes as MeshNumber. */
  arguments: unknown[];
  /** Whether the worker tells progress. */
  reports: boolean;
}

export type Reply =
  | { id: number; progress: number }
  | { id: number; value: unknown }
  | { id: number; error: { kind: string; message: string } };
