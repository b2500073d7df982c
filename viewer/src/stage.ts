// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { PerspectiveCamera, Quaternion, Vector3, Vector4, WebGLRenderer, WebGLRenderTarget } from "three";
import type { Side } from "./modes";
import type { Surface } from "./surface";

/** The view of a mesh: rotation about the vertical and the horizontal axis, shift, and zoom. */
export interface View {
  yaw: number;
  pitch: number;
  zoom: number;
  x: number;
  y: number;
}
export const homeView = (): View => ({ yaw: 0.45, pitch: 0.18, zoom: 1, x: 0, y: 0 });

export interface Rectangle {
  left: number;
  top: number;
  width: number;
  height: number;
}
/** One mesh on the stage. */
export interface Pane {
  side: Side;
  surface: Surface;
}
export interface ScreenPoint {
  x: number;
  y: number;
  /** The surface faces the viewer there. */
  facing: boolean;
}

const fieldOfView = 28;
const xAxis = new Vector3(1, 0, 0);
const yAxis = new Vector3(0, 1, 0);

/** Meshes on one canvas, in the rows and columns that show them largest. */
export class Stage {
  readonly views: Record<Side, View> = { source: homeView(), target: homeView() };
  private readonly renderer: WebGLRenderer;
  private readonly camera = new PerspectiveCamera(fieldOfView, 1, 0.05, 50);
  private readonly pixel = new WebGLRenderTarget(1, 1);
  private width = 1;
  private height = 1;
  private captionHeight = 0;
  /** Half the width that a pane has to show; half the height is 1. */
  private readonly reach: number;

  constructor(
    readonly canvas: HTMLCanvasElement,
    public panes: Pane[],
  ) {
    this.reach = Math.max(0.1, ...panes.map(({ surface }) => surface.reach()));
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setScissorTest(true);
  }

  /** Adopts the canvas's size on the page; false if it has not changed. */
  resize(): boolean {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === this.width && height === this.height) return false;
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(this.width, this.height, false);
    return true;
  }

  /** Leaves so much room for a caption above each mesh. */
  setCaptionHeight(height: number): void {
    this.captionHeight = height;
  }

  private grid(): { columns: number; rows: number } {
    let [best, columns] = [0, 1];
    for (let count = this.panes.length; count > 0; --count) {
      const height = this.height / Math.ceil(this.panes.length / count) - this.captionHeight;
      const size = Math.min(this.width / count / this.reach, height);
      if (size >= best) [best, columns] = [size, count]; // of equals the fewest columns
    }
    return { columns, rows: Math.ceil(this.panes.length / columns) };
  }

  /** All that belongs to a pane. */
  cell(pane: number): Rectangle {
    const { columns, rows } = this.grid();
    const [width, height] = [this.width / columns, this.height / rows];
    return { left: (pane % columns) * width, top: Math.floor(pane / columns) * height, width, height };
  }

  /** Where its mesh is drawn: below the caption. */
  rectangle(pane: number): Rectangle {
    const { left, top, width, height } = this.cell(pane);
    const caption = Math.min(this.captionHeight, height / 2);
    return { left, top: top + caption, width, height: height - caption };
  }

  paneAt(x: number, y: number): number {
    const { columns, rows } = this.grid();
    const place = (share: number, count: number) => Math.min(Math.max(Math.floor(share * count), 0), count - 1);
    const pane = place(y / this.height, rows) * columns + place(x / this.width, columns);
    return Math.min(pane, this.panes.length - 1);
  }

  viewOf(pane: number): View {
    return this.views[this.panes[pane].side];
  }

  /** Length of a pixel in the plane through the middle of the mesh, in the mesh's normalized units. */
  unitsPerPixel(pane: number): number {
    return (2 * this.halfHeight(pane)) / this.rectangle(pane).height;
  }

  draw(): void {
    for (const [pane, { surface }] of this.panes.entries()) {
      const { left, top, width, height } = this.rectangle(pane);
      const bottom = this.height - top - height;
      this.aim(pane);
      this.renderer.setViewport(left, bottom, width, height);
      this.renderer.setScissor(left, bottom, width, height);
      this.renderer.render(surface.scene, this.camera);
    }
  }

  project(pane: number, vertex: number): ScreenPoint {
    this.aim(pane);
    const { surface } = this.panes[pane];
    const { left, top, width, height } = this.rectangle(pane);
    const point = surface.position(vertex, new Vector3()).applyMatrix4(surface.object.matrixWorld);
    const toCamera = this.camera.position.clone().sub(point);
    const normal = new Vector3().fromArray(surface.normals, 3 * vertex).applyQuaternion(surface.object.quaternion);
    point.project(this.camera);
    return {
      x: left + ((point.x + 1) / 2) * width,
      y: top + ((1 - point.y) / 2) * height,
      facing: normal.dot(toCamera) > 0,
    };
  }

  /** The vertex nearest to a point of the canvas, among the corners of the triangle visible there. */
  pick(x: number, y: number): { pane: number; vertex: number } | null {
    const pane = this.paneAt(x, y);
    const corner = this.cornerAt(pane, x, y);
    if (corner === null) return null;
    const { topology, data } = this.panes[pane].surface;
    const screen = new Map<number, ScreenPoint>();
    const at = (vertex: number): ScreenPoint => {
      const known = screen.get(vertex) ?? this.project(pane, vertex);
      screen.set(vertex, known);
      return known;
    };
    // The picked pixel gives one corner of the triangle, which is one of those around that corner.
    let best = corner;
    let bestDistance = Infinity;
    for (let i = topology.first[corner]; i < topology.first[corner + 1]; i++) {
      const t = 3 * topology.incident[i];
      const corners = [data.triangles[t], data.triangles[t + 1], data.triangles[t + 2]];
      if (!isInside(x, y, corners.map(at))) continue;
      for (const vertex of corners) {
        const p = at(vertex);
        const distance = Math.hypot(p.x - x, p.y - y);
        if (distance < bestDistance) [best, bestDistance] = [vertex, distance];
      }
    }
    return { pane, vertex: best };
  }

  /** Draws one pixel of vertex indices and reads it: visibility is decided by the depth buffer. */
  private cornerAt(pane: number, x: number, y: number): number | null {
    const { left, top, width, height } = this.rectangle(pane);
    this.aim(pane);
    this.camera.setViewOffset(width, height, x - left - 0.5, y - top - 0.5, 1, 1);
    const { surface } = this.panes[pane];
    const scissor = this.renderer.getScissor(new Vector4());
    this.renderer.setRenderTarget(this.pixel);
    this.renderer.clear();
    surface.whilePicking(() => this.renderer.render(surface.scene, this.camera));
    const bytes = new Uint8Array(4);
    this.renderer.readRenderTargetPixels(this.pixel, 0, 0, 1, 1, bytes);
    this.renderer.setRenderTarget(null);
    this.renderer.setScissor(scissor);
    this.camera.clearViewOffset();
    const id = new DataView(bytes.buffer).getUint32(0, true);
    return id === 0 ? null : id - 1;
  }

  private halfHeight(pane: number): number {
    const { width, height } = this.rectangle(pane);
    return (1.04 * Math.max(1, (this.reach * height) / width)) / this.viewOf(pane).zoom;
  }

  private aim(pane: number): void {
    const view = this.viewOf(pane);
    const { width, height } = this.rectangle(pane);
    const distance = 1 / Math.sin((fieldOfView * Math.PI) / 360) + 0.5;
    // Zoom narrows the field of view, so that the camera never enters the mesh.
    this.camera.fov = (360 / Math.PI) * Math.atan(this.halfHeight(pane) / distance);
    this.camera.aspect = width / height;
    this.camera.position.set(view.x, view.y, distance);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    const { surface } = this.panes[pane];
    surface.object.quaternion
      .setFromAxisAngle(xAxis, view.pitch)
      .multiply(new Quaternion().setFromAxisAngle(yAxis, view.yaw))
      .multiply(surface.upright);
    surface.object.updateMatrixWorld();
  }
}

function isInside(x: number, y: number, [a, b, c]: ScreenPoint[]): boolean {
  const turn = (p: ScreenPoint, q: ScreenPoint) => (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
  const [u, v, w] = [turn(a, b), turn(b, c), turn(c, a)];
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}
