// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Content } from "./core.js";
import type { MeshObject } from "./types.js";

/** A mesh with its attributes. The arrays are copies; the mesh itself is held in WebAssembly's memory until it is freed. */
export class Mesh {
  /** Three coordinates for each vertex. */
  readonly vertices: Float64Array;
  /** Three vertices for each triangle, from 0. */
  readonly triangles: Int32Array;
  /** Sentences on what the reader changed. */
  readonly notices: readonly string[];
  /** What it has besides the triangles: colors, textureCoordinates, normals, skin, morphs, materials. */
  readonly attributes: readonly string[];
  /** Its objects, as `object` of `readMesh` chooses one. */
  readonly objects: readonly MeshObject[];

  /** @internal */
  constructor(
    readonly name: string,
    /** @internal */ readonly content: Content,
  ) {
    this.vertices = content.vertices();
    this.triangles = content.triangles();
    this.notices = content.notices();
    this.attributes = content.attributes();
    this.objects = content.objects();
    registry.register(this, content, this);
  }

  get nVertices(): number {
    return this.vertices.length / 3;
  }
  get nTriangles(): number {
    return this.triangles.length / 3;
  }

  /** Gives its memory back at once; else that happens some time after nothing refers to it. */
  free(): void {
    registry.unregister(this);
    this.content.delete();
  }
}

const registry = new FinalizationRegistry<Content>((content) => content.delete());
