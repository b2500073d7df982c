// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What the compiled library (javascript/src) gives.
import type { Evaluation, Extensions, MatchResult, MeshObject, Message, TransferredAttribute, ViewerScene } from "./types.js";

export interface Content {
  vertices(): Float64Array;
  triangles(): Int32Array;
  attributes(): string[];
  notices(): string[];
  objects(): MeshObject[];
  delete(): void;
}

export type Outcome<Value> = { value: Value } | { error: { kind: string; message: string } };

type Step = ((fraction: number) => boolean) | null;

export interface Core {
  readContent(name: string, strict: boolean, object: string | null): Outcome<Content>;
  writeContent(content: Content, name: string): Outcome<true>;
  contentOf(vertices: Float64Array, triangles: Int32Array): Outcome<Content>;
  extensions(): Extensions;
  match(source: Content, target: Content, options: string, initial: Int32Array | null, progress: Step): Outcome<MatchResult>;
  evaluate(source: Content, target: Content, map: Int32Array, truth: Int32Array): Outcome<Evaluation>;
  reorder(source: Content, target: Content, allowMirror: boolean, weldDistance: number): Outcome<Content>;
  transfer(source: Content, target: Content, map: Int32Array, progress: Step): Outcome<Transferred>;
  viewerScene(
    source: Content,
    target: Content,
    sourceName: string,
    targetName: string,
    maps: readonly { targetFromSource: Int32Array; description: string }[],
    confidence: Float64Array,
  ): Outcome<ViewerScene>;
  example(kind: string): Outcome<[Content, Content]>;
  FS: FileSystem;
  HEAPU8: Uint8Array;
}

export interface Transferred {
  content: Content;
  attributes: TransferredAttribute[];
  messages: Message[];
}

/** Emscripten's files in memory. */
export interface FileSystem {
  mkdir(path: string): void;
  chdir(path: string): void;
  writeFile(path: string, data: Uint8Array, options?: { canOwn?: boolean }): void;
  readFile(path: string): Uint8Array;
  readdir(path: string): string[];
  unlink(path: string): void;
}

export type InstantiateWasm = (
  imports: WebAssembly.Imports,
  receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
) => object;

export type MakeCore = (module: {
  instantiateWasm: InstantiateWasm;
  mainScriptUrlOrBlob?: string;
  locateFile?: (name: string) => string;
}) => Promise<Core>;
