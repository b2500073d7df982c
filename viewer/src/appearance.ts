// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  ShaderMaterial,
  Texture,
} from "three";
import type { AppearanceData, MeshData } from "./scene_data";
import { appearanceFragmentShader, appearanceVertexShader } from "./shaders";

/** A mesh with its own images and colors. Its corners are apart, so that seams show. */
export class Appearance {
  readonly geometry = new BufferGeometry();
  readonly materials: ShaderMaterial[];
  /** Vertex of each corner, in the order of the geometry. */
  private readonly vertices: Uint32Array;

  constructor(
    mesh: MeshData,
    data: AppearanceData,
    morph: { value: number },
    /** An image is there now. */
    loaded: () => void,
  ) {
    const images = data.imageOfTriangle ?? new Int32Array(mesh.triangleCount).fill(-1);
    const order = Array.from(images.keys()).sort((a, b) => images[a] - images[b] || a - b);
    const corners = order.flatMap((t) => [3 * t, 3 * t + 1, 3 * t + 2]);
    this.vertices = Uint32Array.from(corners, (corner) => mesh.triangles[corner]);
    if (data.uv) this.geometry.setAttribute("uv", new BufferAttribute(rows(data.uv, corners, 2), 2));
    if (data.colors) this.geometry.setAttribute("tint", new BufferAttribute(rows(data.colors, corners, 3), 3, true));
    const textures = data.images.map((bytes) => textureOf(bytes, loaded));
    this.materials = [null, ...textures].map((image) => material(image, data.colors !== null, morph));
    let start = 0;
    for (let image = -1; image < textures.length; image++) {
      const count = 3 * images.reduce((n, i) => n + Number(i === image), 0);
      if (count > 0) this.geometry.addGroup(start, count, image + 1);
      start += count;
    }
  }

  /** Vertices where the mesh has them at the start or the end of the morph. */
  place(attribute: string, values: Float32Array): void {
    this.geometry.setAttribute(attribute, new BufferAttribute(rows(values, this.vertices, 3) as Float32Array, 3));
  }
}

function rows<T extends Float32Array | Uint8Array>(values: T, numbers: ArrayLike<number>, width: number): T {
  const result = new (values.constructor as new (length: number) => T)(width * numbers.length);
  for (let i = 0; i < numbers.length; i++)
    for (let k = 0; k < width; k++) result[width * i + k] = values[width * numbers[i] + k];
  return result;
}

function textureOf(bytes: Uint8Array, loaded: () => void): Texture {
  const texture = new Texture();
  texture.flipY = false; // the first row is at v = 0
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.minFilter = LinearMipmapLinearFilter;
  createImageBitmap(new Blob([bytes.slice()]), { premultiplyAlpha: "none", colorSpaceConversion: "none" }).then(
    (bitmap) => {
      texture.image = bitmap;
      texture.needsUpdate = true;
      loaded();
    },
    () => loaded(), // damaged: the surface stays black
  );
  return texture;
}

function material(image: Texture | null, tinted: boolean, morph: { value: number }): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    vertexShader: appearanceVertexShader,
    fragmentShader: appearanceFragmentShader,
    defines: { ...(image && { TEXTURED: "" }), ...(tinted && { TINTED: "" }) },
    uniforms: { morph, image: { value: image } },
  });
}
