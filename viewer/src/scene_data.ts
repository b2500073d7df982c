// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// What `counterpart view` put into the page: a small JSON description and one block of little-endian arrays
// (src/viewer/viewer_page.cpp writes both).

export interface MeshData {
  name: string;
  vertexCount: number;
  triangleCount: number;
  /** Centered at the middle of the box, divided by half its diagonal; xyz per vertex. */
  positions: Float32Array;
  triangles: Uint16Array | Uint32Array;
  /** What it looks like by itself; null where its file says nothing. */
  appearance: AppearanceData | null;
}

export interface AppearanceData {
  /** Two numbers per corner, (0, 0) at the image's top left. */
  uv: Float32Array | null;
  /** -1 = none. */
  imageOfTriangle: Int32Array | null;
  /** Whole PNG, JPEG or WebP files. */
  images: Uint8Array[];
  /** Red, green, blue per corner. */
  colors: Uint8Array | null;
}

export interface MapData {
  name: string;
  /** Target vertex of each source vertex, -1 = unmatched. */
  image: Int32Array;
  /** Per source vertex in units of sqrt(target area) / 100, NaN = unknown; null where there is no truth at all. */
  error: Float32Array | null;
  /** What `counterpart evaluate` says of the map; empty where there is no truth. */
  evaluation: string;
  /** "use", "check" or "do not use"; empty where nobody judged. */
  verdict: string;
  /** What may be wrong with it, a sentence each. */
  warnings: string[];
  /** 0 .. 1 per source vertex, NaN = unknown; null where none is known. */
  confidence: Float32Array | null;
}

/** Numbers per source vertex, NaN = unknown. */
export interface ValueData {
  name: string;
  values: Float32Array;
}

export interface SceneData {
  source: MeshData;
  target: MeshData;
  maps: MapData[];
  values: ValueData[];
  truth: Int32Array | null;
  baseVertex: number;
  /** Quaternions x y z w. */
  viewFromSource: number[];
  sourceFromTarget: number[];
}

interface MeshJson {
  name: string;
  vertices: number;
  triangles: number;
  low: number[];
  extent: number[];
  position_offset: number;
  triangle_offset: number;
  triangle_bytes: number;
  uv_offset?: number;
  image_of_triangle_offset?: number;
  images?: { offset: number; bytes: number }[];
  color_offset?: number;
}

interface MapJson {
  name: string;
  image_offset: number;
  error_offset?: number;
  confidence_offset?: number;
  evaluation?: string;
  verdict?: string;
  warnings?: string[];
}

function elementText(id: string): string {
  const element = document.getElementById(id);
  if (!element?.textContent) throw new Error("This page contains no meshes: create it with 'counterpart view'.");
  return element.textContent;
}

function decodeBase64(text: string): ArrayBuffer {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}

function readMesh(json: MeshJson, buffer: ArrayBuffer): MeshData {
  const fractions = new Uint16Array(buffer, json.position_offset, 3 * json.vertices);
  const radius = 0.5 * Math.hypot(...json.extent) || 1;
  const scale = json.extent.map((extent) => extent / 65535 / radius);
  const shift = json.extent.map((extent) => extent / 2 / radius);
  const positions = new Float32Array(fractions.length);
  for (let i = 0; i < fractions.length; i++) positions[i] = fractions[i] * scale[i % 3] - shift[i % 3];
  const Indices = json.triangle_bytes === 2 ? Uint16Array : Uint32Array;
  return {
    name: json.name,
    vertexCount: json.vertices,
    triangleCount: json.triangles,
    positions,
    triangles: new Indices(buffer, json.triangle_offset, 3 * json.triangles),
    appearance: readAppearance(json, buffer),
  };
}

function numbersAt(offset: number | undefined, source: MeshData, buffer: ArrayBuffer): Float32Array | null {
  return offset === undefined ? null : new Float32Array(buffer, offset, source.vertexCount);
}

function readAppearance(json: MeshJson, buffer: ArrayBuffer): AppearanceData | null {
  const { uv_offset: uv, image_of_triangle_offset: number, color_offset: color, images } = json;
  if (uv === undefined && color === undefined) return null;
  return {
    uv: uv === undefined ? null : new Float32Array(buffer, uv, 6 * json.triangles),
    imageOfTriangle: number === undefined ? null : new Int32Array(buffer, number, json.triangles),
    images: (images ?? []).map(({ offset, bytes }) => new Uint8Array(buffer, offset, bytes)),
    colors: color === undefined ? null : new Uint8Array(buffer, color, 9 * json.triangles),
  };
}

/** The scene that the page holds. */
export function readScene(): SceneData {
  const description = JSON.parse(elementText("scene"));
  const text = document.getElementById("buffer");
  const buffer = decodeBase64(elementText("buffer"));
  text?.remove(); // frees megabytes that are not needed again
  return sceneOf(description, buffer);
}

/** The scene of its description and of the arrays that this speaks of. */
export function sceneOf(json: any, buffer: ArrayBuffer): SceneData {
  const source = readMesh(json.source, buffer);
  const target = readMesh(json.target, buffer);
  return {
    source,
    target,
    maps: json.maps.map((map: MapJson) => ({
      name: map.name,
      image: new Int32Array(buffer, map.image_offset, source.vertexCount),
      error: numbersAt(map.error_offset, source, buffer),
      evaluation: map.evaluation ?? "",
      verdict: map.verdict ?? "",
      warnings: map.warnings ?? [],
      confidence: numbersAt(map.confidence_offset, source, buffer),
    })),
    values: (json.values ?? []).map((value: { name: string; offset: number }) => ({
      name: value.name,
      values: new Float32Array(buffer, value.offset, source.vertexCount),
    })),
    truth: json.truth_offset === undefined ? null : new Int32Array(buffer, json.truth_offset, source.vertexCount),
    baseVertex: json.base_vertex,
    viewFromSource: json.view_from_source,
    sourceFromTarget: json.source_from_target,
  };
}
