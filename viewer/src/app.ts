// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { Quaternion, Vector3 } from "three";
import { Correspondence } from "./correspondence";
import { carry, type Field, fill, positionField, scalarField } from "./field";
import { Interaction } from "./interaction";
import type { Mode, Selection, Side } from "./modes";
import { type Line, type Marker, Overlay } from "./overlay";
import { errorStops, interpolate, positionColor } from "./palette";
import { element, Panel } from "./panel";
import { colorLegend, describe, errorLegend, levelLegend, valueLegend } from "./readout";
import { sampleVertices } from "./sample";
import type { SceneData } from "./scene_data";
import { type ScreenPoint, Stage } from "./stage";
import { Surface } from "./surface";

const sourceColor = "#ffd23f";
const targetColor = "#ff5fa2";
const truthColor = "#3ddc84";
const maxMarkers = 50; // of the source vertices that share a target vertex
const frontierBands = 24;

/** Holds the state of the page and redraws when it changes. */
export class App {
  private readonly surfaces: Record<Side, Surface>;
  private readonly stage: Stage;
  private readonly overlay = new Overlay(element<HTMLCanvasElement>("overlay"));
  private readonly interaction: Interaction;
  private readonly panel: Panel;
  private readonly correspondences: Correspondence[];
  private readonly samples: number[];
  private mapIndex = 0;
  private mode: Mode = "colors";
  private lineCount = 0;
  private morph = 0;
  private goalMap = -1; // map that the morph's goal was computed for
  private base: number;
  private hovered: Selection | null = null;
  private pinned: Selection | null = null;
  private pointer: { x: number; y: number } | null = null;
  private frame = 0;
  private valuesIndex = 0;
  private errorEnd: number | null = null; // null = automatic
  private isPicking = false;
  private pickedSource: number | null = null;
  private landmarks: [number, number][] = [];
  private meshesChanged = false;
  /** Number of times the meshes were drawn. */
  frames = 0;

  constructor(private readonly scene: SceneData) {
    const view = new Quaternion().fromArray(scene.viewFromSource);
    this.surfaces = {
      source: new Surface(scene.source, view),
      target: new Surface(scene.target, view.clone().multiply(new Quaternion().fromArray(scene.sourceFromTarget))),
    };
    this.correspondences = scene.maps.map((map) => new Correspondence(map, scene));
    this.base = scene.baseVertex >= 0 ? scene.baseVertex : this.surfaces.source.topology.extremity();
    this.samples = sampleVertices(scene.source, 200);
    this.stage = new Stage(element<HTMLCanvasElement>("meshes"), this.surfaces);
    this.interaction = new Interaction(this.stage, {
      viewChanged: () => this.requestFrame(),
      hover: (x, y) => {
        this.pointer = { x, y };
        this.panel.pointed();
        this.requestFrame("overlay");
      },
      leave: () => {
        this.pointer = null;
        this.highlight(null);
      },
      select: (x, y) => {
        const selection = this.stage.pick(x, y);
        if (this.isPicking && selection) this.pickLandmark(selection);
        this.pin(selection);
      },
      release: () => this.pin(null),
    });
    this.panel = new Panel(scene, this.mode, {
      mode: (mode) => {
        this.mode = mode;
        this.recolor();
      },
      map: (index) => {
        this.mapIndex = index;
        this.updateMorph();
        this.recolor();
        this.updateText();
      },
      lines: (count) => {
        this.lineCount = count;
        this.requestFrame();
      },
      morph: (amount) => {
        this.morph = amount;
        this.updateMorph();
      },
      linked: (linked) => {
        this.interaction.linked = linked;
      },
      reset: () => this.interaction.reset(),
      vertex: (vertex) => this.pin({ side: "source", vertex }),
      values: (index) => {
        this.valuesIndex = index;
        this.recolor();
      },
      scale: (top) => {
        this.errorEnd = top;
        this.recolor();
      },
      picking: (picking) => {
        this.isPicking = picking;
        this.pickedSource = null;
        this.showLandmarks();
      },
      saveLandmarks: () => this.saveLandmarks(),
      clearLandmarks: () => {
        this.landmarks = [];
        this.showLandmarks();
      },
    });
    this.nameMeshes();
    new ResizeObserver(() => this.resize()).observe(this.stage.canvas);
    this.recolor();
    this.updateText();
    this.resize();
  }

  // ---- for scripts ----

  /** Where a vertex is on the page. */
  screenPosition(side: Side, vertex: number): ScreenPoint {
    const point = this.stage.project(side, vertex);
    const box = this.stage.canvas.getBoundingClientRect();
    return { ...point, x: point.x + box.left, y: point.y + box.top };
  }

  /** The vertices marked on both meshes. */
  highlighted(): Record<Side, number[]> {
    const selection = this.hovered ?? this.pinned;
    if (!selection) return { source: [], target: [] };
    if (selection.side === "target")
      return { source: this.current.sourcesOf(selection.vertex), target: [selection.vertex] };
    const image = this.current.map.image[selection.vertex];
    return { source: [selection.vertex], target: image < 0 ? [] : [image] };
  }

  /** Draws and waits for the graphics card; milliseconds. */
  measureFrame(): number {
    const start = performance.now();
    this.draw();
    this.stage.pick(1, 1); // reading a pixel back waits for drawing
    return performance.now() - start;
  }

  // ---- state ----

  private get current(): Correspondence {
    return this.correspondences[this.mapIndex];
  }

  private highlight(selection: Selection | null): void {
    if (selection?.side === this.hovered?.side && selection?.vertex === this.hovered?.vertex) return;
    this.hovered = selection;
    this.updateText();
    this.requestFrame("overlay");
  }

  private pin(selection: Selection | null): void {
    this.pinned = selection;
    this.hovered = null;
    this.pointer = null;
    const source = this.highlighted().source[0];
    if (source !== undefined && source !== this.base) {
      this.base = source;
      if (this.mode === "frontiers") this.recolor();
    }
    this.updateText();
    this.requestFrame();
  }

  // ---- landmarks ----

  /** A vertex of the source, then one of the target, are a pair. */
  private pickLandmark({ side, vertex }: Selection): void {
    if (side === "source") {
      this.pickedSource = vertex;
    } else if (this.pickedSource !== null) {
      this.landmarks.push([this.pickedSource, vertex]);
      this.pickedSource = null;
    }
    this.showLandmarks();
  }

  private showLandmarks(): void {
    this.panel.showLandmarks(this.landmarks.length, this.pickedSource === null ? "" : "now its counterpart");
    this.requestFrame("overlay");
  }

  /** As `counterpart match --landmarks` reads it. */
  private saveLandmarks(): void {
    const lines = this.landmarks.map(([source, target]) => `${source} ${target}\n`);
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob(lines, { type: "text/plain" }));
    link.download = "landmarks.txt";
    link.click();
    URL.revokeObjectURL(link.href);
  }

  private updateMorph(): void {
    if (this.morph > 0 && this.goalMap !== this.mapIndex) {
      this.goalMap = this.mapIndex;
      this.surfaces.source.setGoal(...this.morphGoal());
    }
    this.surfaces.source.morph = this.morph;
    this.requestFrame();
  }

  /** Positions of the images of the source's vertices, in the source's frame; unmatched vertices follow their neighbors. */
  private morphGoal(): [Float32Array, Float32Array] {
    const { source, target } = this.surfaces;
    const rotation = new Quaternion().fromArray(this.scene.sourceFromTarget);
    const image = this.current.map.image;
    const gather = (values: Float32Array): Float32Array => {
      const field: Field = new Float32Array(4 * image.length);
      const value = new Vector3();
      image.forEach((to, v) => {
        if (to < 0) return;
        value.fromArray(values, 3 * to).applyQuaternion(rotation).toArray(field, 4 * v);
        field[4 * v + 3] = 1;
      });
      fill(field, source.topology, Infinity);
      return Float32Array.from({ length: 3 * image.length }, (_, i) => field[4 * Math.floor(i / 3) + (i % 3)]);
    };
    return [gather(target.data.positions), gather(target.normals)];
  }

  // ---- colors ----

  private recolor(): void {
    const { source, target } = this.surfaces;
    const { field, top, bandWidth } = this.sourceField();
    const carried = field ? carry(field, this.current.map.image, target.topology) : null;
    const cells = this.checkerCells();
    source.show(this.mode, field, top, bandWidth, cells);
    target.show(this.mode, carried, top, bandWidth, cells);
    this.updateLegend(top, bandWidth);
    this.requestFrame();
  }

  private sourceField(): { field: Field | null; top: number; bandWidth: number } {
    const { map } = this.current;
    switch (this.mode) {
      case "colors":
      case "checker":
        return { field: positionField(this.scene.source.positions, map.image), top: 1, bandWidth: 1 };
      case "error": {
        const error = map.error ?? new Float32Array(map.image.length).fill(NaN);
        return { field: scalarField(error, (v) => !Number.isNaN(error[v])), top: this.errorTop(), bandWidth: 1 };
      }
      case "frontiers": {
        const levels = this.surfaces.source.topology.levels(this.base);
        const top = levels.reduce((a, b) => Math.max(a, b), 1);
        const field = scalarField(levels, (v) => levels[v] >= 0);
        return { field, top, bandWidth: Math.max(1, Math.round(top / frontierBands)) };
      }
      case "values": {
        const { values } = this.scene.values[this.valuesIndex];
        const [low, high] = this.valueRange();
        const scaled = values.map((value) => (value - low) / (high - low || 1));
        return { field: scalarField(scaled, (v) => Number.isFinite(values[v])), top: 1, bandWidth: 1 };
      }
      case "plain":
        return { field: null, top: 1, bandWidth: 1 };
    }
  }

  /** One scale for all maps, so that they can be compared. */
  private errorTop(): number {
    if (this.errorEnd !== null) return this.errorEnd;
    return Math.max(...this.correspondences.filter(({ map }) => map.error).map((c) => c.errorScale()), 1e-6);
  }

  private valueRange(): [number, number] {
    const known = this.scene.values[this.valuesIndex].values.filter(Number.isFinite);
    return [known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), -Infinity)];
  }

  /** Cells of the checkerboard along each axis. */
  private checkerCells(): Vector3 {
    const size = new Vector3().subVectors(...this.sourceBox());
    const longest = Math.max(size.x, size.y, size.z);
    return size.divideScalar(longest / 12);
  }

  private sourceBox(): [Vector3, Vector3] {
    const box = this.surfaces.source.object.geometry;
    if (!box.boundingBox) box.computeBoundingBox();
    return [box.boundingBox!.max, box.boundingBox!.min];
  }

  // ---- words ----

  private nameMeshes(): void {
    for (const side of ["source", "target"] as const) {
      const { name, vertexCount, triangleCount } = this.scene[side];
      const title = document.createElement("b");
      title.textContent = name;
      const size = document.createElement("span");
      size.className = "size";
      size.textContent = ` · ${vertexCount.toLocaleString("en")} vertices, ${triangleCount.toLocaleString("en")} triangles`;
      const role = name === side ? "" : ` · ${side}`;
      element(`${side}-name`).replaceChildren(title, role, size);
    }
    const title = `${this.scene.source.name} → ${this.scene.target.name}`;
    element("title").textContent = title;
    document.title = `${title} · counterpart`;
  }

  private updateText(): void {
    const selection = this.hovered ?? this.pinned;
    element("stats").textContent = this.current.summary();
    const words = describe(selection, this.current, this.correspondences, this.scene);
    element("answer").replaceChildren(...words.flatMap((word) => [word, " "]));
    this.panel.showVertex(this.highlighted().source[0] ?? null);
  }

  private updateLegend(top: number, bandWidth: number): void {
    const legend = element("legend");
    if (this.mode === "error") legend.replaceChildren(...errorLegend(top));
    else if (this.mode === "values")
      legend.replaceChildren(...valueLegend(this.scene.values[this.valuesIndex].name, ...this.valueRange()));
    else if (this.mode === "frontiers") legend.replaceChildren(...levelLegend(this.base, top, bandWidth));
    else legend.replaceChildren(...colorLegend());
    const complete =
      this.current.matched === this.scene.source.vertexCount && this.current.covered === this.scene.target.vertexCount;
    legend.hidden = this.mode === "plain" || ((this.mode === "colors" || this.mode === "checker") && complete);
  }

  // ---- drawing ----

  private resize(): void {
    if (!this.stage.resize()) return;
    this.overlay.resize();
    for (const side of ["source", "target"] as const) {
      const { left, top } = this.stage.rectangle(side);
      Object.assign(element(`${side}-name`).style, { left: `${left + 10}px`, top: `${top + 8}px` });
    }
    // The canvas is empty now: draw before it is shown, and only once if something else changed too.
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.draw();
  }

  /** Hovering changes the markers only: the meshes stay as they were drawn. */
  private requestFrame(what: "all" | "overlay" = "all"): void {
    if (what === "all") this.meshesChanged = true;
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      if (this.pointer) {
        const { x, y } = this.pointer;
        this.pointer = null;
        this.highlight(this.stage.pick(x, y));
      }
      if (this.meshesChanged) this.draw();
      else this.drawOverlay();
    });
  }

  private draw(): void {
    this.meshesChanged = false;
    this.frames++;
    this.stage.draw();
    this.drawOverlay();
  }

  private drawOverlay(): void {
    const { source, target } = this.highlighted();
    const markers: Marker[] = [];
    const shown = source.slice(0, maxMarkers);
    const truth = shown.length > 0 ? (this.scene.truth?.[shown[0]] ?? -1) : -1;
    if (truth >= 0) markers.push({ at: this.stage.project("target", truth), color: truthColor, shape: "ring" });
    for (const v of shown) markers.push({ at: this.stage.project("source", v), color: sourceColor, shape: "disc" });
    for (const v of target) markers.push({ at: this.stage.project("target", v), color: targetColor, shape: "disc" });
    for (const [from, to] of this.landmarks) {
      markers.push({ at: this.stage.project("source", from), color: truthColor, shape: "ring" });
      markers.push({ at: this.stage.project("target", to), color: truthColor, shape: "ring" });
    }
    let link: Line | null = null;
    if (shown.length > 0 && target.length > 0)
      link = this.line(shown[0], target[0], getComputedStyle(document.body).color);
    this.overlay.draw(this.sampleLines(), link, markers);
  }

  private line(from: number, to: number, color: string): Line {
    return { from: this.stage.project("source", from), to: this.stage.project("target", to), color };
  }

  private sampleLines(): Line[] {
    const { map } = this.current;
    const [high, low] = this.sourceBox();
    const lines: Line[] = [];
    for (const v of this.samples.slice(0, this.lineCount)) {
      if (map.image[v] < 0) continue;
      const p = new Vector3().fromArray(this.scene.source.positions, 3 * v).sub(low).divide(new Vector3().subVectors(high, low));
      const error = map.error?.[v] ?? NaN;
      const color =
        this.mode === "error" && !Number.isNaN(error)
          ? interpolate(errorStops, error / this.errorTop())
          : positionColor(p.x || 0, p.y || 0, p.z || 0);
      lines.push(this.line(v, map.image[v], color));
    }
    return lines;
  }
}
