// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, Quaternion, Scene, ShaderMaterial, Vector3 } from "three";
import { Appearance } from "./appearance";
import type { Field } from "./field";
import { type Mode, modes } from "./modes";
import type { MeshData } from "./scene_data";
import { pickFragmentShader, pickVertexShader, surfaceFragmentShader, surfaceVertexShader } from "./shaders";
import { Topology } from "./topology";

/** One mesh on the graphics card, with its field and the goal of its morph. */
export class Surface {
  readonly topology: Topology;
  readonly normals: Float32Array;
  readonly scene = new Scene();
  readonly object: Mesh<BufferGeometry, ShaderMaterial | ShaderMaterial[]>;
  private readonly geometry = new BufferGeometry();
  private readonly morphUniform = { value: 0 };
  private goal: Float32Array | null = null;
  private readonly shading: ShaderMaterial;
  private readonly picking: ShaderMaterial;
  private appearance: Appearance | null = null; // made when it is first shown

  constructor(
    readonly data: MeshData,
    /** Rotates the mesh upright, before any rotation by hand. */
    readonly upright: Quaternion,
    /** Another surface of the same mesh, whose topology this one shares. */
    same?: Surface,
    /** An image of the mesh has come: draw again. */
    private readonly imageLoaded: () => void = () => {},
  ) {
    this.topology = same?.topology ?? new Topology(data);
    this.normals = same?.normals ?? this.topology.normals();
    this.geometry.setAttribute("position", new BufferAttribute(data.positions, 3));
    this.geometry.setAttribute("normal", new BufferAttribute(this.normals, 3));
    this.geometry.setIndex(new BufferAttribute(data.triangles, 1));
    this.setGoal(data.positions, this.normals);
    this.shading = new ShaderMaterial({
      glslVersion: GLSL3,
      side: DoubleSide,
      vertexShader: surfaceVertexShader,
      fragmentShader: surfaceFragmentShader,
      uniforms: {
        morph: this.morphUniform,
        mode: { value: 0 },
        top: { value: 1 },
        bandWidth: { value: 1 },
        cells: { value: new Vector3(1, 1, 1) },
      },
    });
    this.picking = new ShaderMaterial({
      glslVersion: GLSL3,
      side: DoubleSide,
      vertexShader: pickVertexShader,
      fragmentShader: pickFragmentShader,
      uniforms: { morph: this.morphUniform },
    });
    this.object = new Mesh(this.geometry, this.shading);
    this.object.frustumCulled = false;
    this.scene.add(this.object);
  }

  /** The highest and the lowest corner of the mesh's box. */
  box(): [Vector3, Vector3] {
    if (!this.geometry.boundingBox) this.geometry.computeBoundingBox();
    return [this.geometry.boundingBox!.max, this.geometry.boundingBox!.min];
  }

  /** The farthest that a vertex lies from the upright axis, about which the mesh is turned: half its width at most. */
  reach(): number {
    let farthest = 0;
    for (let v = 0; v < this.data.vertexCount; v++) {
      const { x, z } = scratch.fromArray(this.data.positions, 3 * v).applyQuaternion(this.upright);
      farthest = Math.max(farthest, Math.hypot(x, z));
    }
    return farthest;
  }

  /** Colors the mesh. `cells`: number of checker cells along each axis. */
  show(mode: Mode, field: Field | null, top: number, bandWidth: number, cells: Vector3): void {
    if (field) this.geometry.setAttribute("field", new BufferAttribute(field, 4));
    const uniforms = this.shading.uniforms;
    uniforms.mode.value = modes.indexOf(mode);
    uniforms.top.value = top;
    uniforms.bandWidth.value = bandWidth;
    uniforms.cells.value = cells;
    const look = mode === "texture" ? this.ownAppearance() : null;
    this.object.geometry = look?.geometry ?? this.geometry;
    this.object.material = look?.materials ?? this.shading;
  }

  private ownAppearance(): Appearance | null {
    if (this.appearance || !this.data.appearance) return this.appearance;
    this.appearance = new Appearance(this.data, this.data.appearance, this.morphUniform, this.imageLoaded);
    this.appearance.place("position", this.data.positions);
    this.appearance.place("normal", this.normals);
    this.placeGoal();
    return this.appearance;
  }

  private placeGoal(): void {
    for (const name of ["goal", "goalNormal"])
      this.appearance?.place(name, this.geometry.getAttribute(name).array as Float32Array);
  }

  /** Where the vertices are at the end of the morph. */
  setGoal(positions: Float32Array, normals: Float32Array): void {
    this.goal = positions;
    this.geometry.setAttribute("goal", new BufferAttribute(positions, 3));
    this.geometry.setAttribute("goalNormal", new BufferAttribute(normals, 3));
    this.placeGoal();
  }

  set morph(amount: number) {
    this.morphUniform.value = amount;
  }

  /** Where a vertex is now, morph included, in the mesh's frame. */
  position(vertex: number, result: Vector3): Vector3 {
    result.fromArray(this.data.positions, 3 * vertex);
    const amount = this.morphUniform.value;
    if (amount > 0 && this.goal) result.lerp(scratch.fromArray(this.goal, 3 * vertex), amount);
    return result;
  }

  /** Runs `draw` with vertex numbers in place of colors. */
  whilePicking(draw: () => void): void {
    const { geometry, material } = this.object;
    this.object.geometry = this.geometry;
    this.object.material = this.picking;
    draw();
    this.object.geometry = geometry;
    this.object.material = material;
  }
}

const scratch = new Vector3();
