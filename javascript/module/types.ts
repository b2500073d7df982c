// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
/** Told the share of the work that is done, 0 to 1, a few times a second; returning false cancels. */
export type Progress = (fraction: number) => boolean | void;
export type Method = "auto" | "exact" | "frontiers" | "partial" | "spectral" | "place" | "nearest" | "assignment";
export type Part = "unknown" | "source" | "target" | "both" | "neither";
/** An axis, or three numbers of any length as a vector. */
export type Direction = "x" | "y" | "z" | "-x" | "-y" | "-z" | readonly [number, number, number];
/** A vertex of the source and one of the target, from 0. */
export type Pair = readonly [source: number, target: number];

export interface ReadOptions {
  /** What the file names beside itself (buffers and images of a glTF file, the .node of an .ele), by name. */
  beside?: Readonly<Record<string, Uint8Array>>;
  /** Refuse vertices whose coordinates are no numbers, instead of leaving them out with a notice. */
  strict?: boolean;
  /** Read this object alone: the one of that name or, if none has it, of that number. Default: the whole file. */
  object?: string;
}

/** Endings of files, with their dots. */
export interface Extensions {
  read: string[];
  written: string[];
}

/** An object of a file: an OBJ's `o` (or `g`), a mesh of a glTF. */
export interface MeshObject {
  name: string;
  nVertices: number;
  nTriangles: number;
}

export interface MatchOptions {
  /** Default: "auto", the best that applies. */
  method?: Method;
  /** Known pairs; they hold exactly unless `softLandmarks`. */
  landmarks?: readonly Pair[];
  softLandmarks?: boolean;
  /** Pairs that do not correspond. */
  excluded?: readonly Pair[];
  /** Both meshes stand in the same frame, if only roughly. */
  aligned?: boolean;
  /** Directions that are the same in both frames; `facing` needs `up`. */
  up?: Direction;
  facing?: Direction;
  /** Whether the target may be the mirror image of what the source shows. Default: "auto", where nothing else fits well. */
  mirror?: "auto" | "never" | "always";
  /** The orientation-reversing map on purpose: left to right. */
  symmetric?: boolean;
  /** Which mesh shows only a part of the other. Default: "unknown". */
  part?: Part;
  /** The files share their unit of length. */
  sameScale?: boolean;
  /** Of exact: let geometry also choose among mirrored matches. */
  allowMirror?: boolean;
  /** Of exact: first weld vertices no further apart, in mesh units. */
  weldDistance?: number;
  /** Of auto: keeps the exact map of what the meshes share if it covers this share of the vertices, 0.5 to 1; default 0.9. */
  minShared?: number;
  /** Of spectral: eigenfunctions. */
  basisSize?: number;
  /** Of spectral: samples, 200 to 5000; default 1000. */
  nSamples?: number;
  /** Another one samples and tries otherwise; good maps hardly depend on it. Default: 0. */
  seed?: number;
  /** Runners-up to report, 0 to 10; default 3. */
  nAlternatives?: number;
  /** A map to be refined instead of searching one. */
  initial?: Int32Array;
  onProgress?: Progress;
}

/** What the library says: sentences for people, codes and severities for programs. */
export interface Message {
  code: string;
  severity: "notice" | "caution" | "do not use";
  sentence: string;
  /** The mesh that it is about, or the map; and the vertices of it (of the map: source vertices), if they are known. */
  subject: "map" | "source" | "target";
  vertices: Int32Array;
}

export interface RunnerUp {
  targetFromSource: Int32Array;
  /** How it differs from the best map. */
  description: string;
}

export interface MatchResult {
  /** The target vertex of each source vertex, from 0; -1: unmatched. */
  targetFromSource: Int32Array;
  /** Per source vertex, 0 to 1: above 0.8 is reliable, below 0.2 is not. */
  confidence: Float64Array;
  /** The method that found the map, and why auto chose it. */
  method: string;
  reason: string;
  /** Whether to rely on the map, and why. */
  verdict: "use" | "check" | "do not use";
  verdictReason: string;
  /** What was noticed and what may be wrong. */
  messages: Message[];
  /** Where the verdict is not to use the map as it is: what may be the cause, the likeliest first. */
  causes: Message[];
  /** The meshes have the same connectivity: `reorder` works. */
  isSameConnectivity: boolean;
  nMatched: number;
  /** Vertices without a partner that follow those around them. */
  nFilled: number;
  runnerUps: RunnerUp[];
  /** Of each stage. */
  seconds: Record<string, number>;
}

export interface ReorderOptions {
  allowMirror?: boolean;
  weldDistance?: number;
}

export interface TransferredAttribute {
  name: string;
  nTransferred: number;
  nFilled: number;
  nGuessed: number;
}

/** Errors in % of the square root of the target's area, along its surface. */
export interface Evaluation {
  nPairs: number;
  nUnmatched: number;
  nOtherComponent: number;
  nExact: number;
  meanError: number;
  medianError: number;
  percentile95Error: number;
  maxError: number;
  /** Of each true pair, in mesh units; infinite in another component, NaN where unmatched. */
  error: Float64Array;
}

/** What the viewer shows: a description in JSON and the arrays that it speaks of. */
export interface ViewerScene {
  description: string;
  arrays: Uint8Array;
}
