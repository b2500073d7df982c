// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { Quaternion, Vector3 } from "three";
import { Correspondence } from "./correspondence";
import { carry, type Field, positionField, scalarField } from "./field";
import { Interaction } from "./interaction";
import { Landmarks } from "./landmarks";
import type { Mode, Selection, Side } from "./modes";
import { morphGoal } from "./morph";
import { Names } from "./names";
import { type Line, type Marker, Overlay } from "./overlay";
import { errorStops, interpolate, positionColor } from "./palette";
import { element, Panel } from "./panel";
import { colorLegend, describe, errorLegend, levelLegend, summarize, valueLegend } from "./readout";
import { sampleVertices } from "./sample";
import type { SceneData } from "./scene_data";
import { type Pane, type ScreenPoint, Stage } from "./stage";
import { Surface } from "./surface";
import { type Values, valuesOf } from "./values";

const sourceColor = "#ffd23f";
const targetColor = "#ff5fa2";
const truthColor = "#3ddc84";
const maxMarkers = 50; // of the source vertices that share a target vertex
const frontierBands = 24;
const maxCompared = 4; // maps side by side

/** Holds the state of the page and redraws when it changes. */
export class App {
  private readonly source: Surface;
  private readonly targets: Surface[]; // one for each map that is shown at once
  private readonly stage: Stage;
  private readonly overlay = new Overlay(element<HTMLCanvasElement>("overlay"));
  private readonly interaction: Interaction;
  private readonly panel: Panel;
  private readonly names: Names;
  private readonly correspondences: Correspondence[];
  private readonly samples: number[];
  private readonly values: Values[];
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
  private isComparing = false;
  private readonly landmarks = new Landmarks();
  private meshesChanged = false;
  /** Number of times the meshes were drawn. */
  frames = 0;

  constructor(private readonly scene: SceneData) {
    const view = new Quaternion().fromArray(scene.viewFromSource);
    const redraw = () => this.requestFrame();
    this.source = new Surface(scene.source, view, undefined, redraw);
    const targetView = view.clone().multiply(new Quaternion().fromArray(scene.sourceFromTarget));
    this.targets = [new Surface(scene.target, targetView, undefined, redraw)];
    this.correspondences = scene.maps.map((map) => new Correspondence(map, scene));
    this.base = scene.baseVertex >= 0 ? scene.baseVertex : this.source.topology.extremity();
    this.samples = sampleVertices(scene.source, 200);
    this.values = valuesOf(scene);
    this.stage = new Stage(element<HTMLCanvasElement>("meshes"), this.panes());
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
        const selection = this.pick(x, y);
        if (this.isPicking && selection) {
          this.landmarks.pick(selection);
          this.showLandmarks();
        }
        this.pin(selection);
      },
      release: () => this.pin(null),
    });
    this.panel = new Panel(scene, this.values, this.mode, {
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
        this.landmarks.stop();
        this.showLandmarks();
      },
      saveLandmarks: () => this.landmarks.save(),
      clearLandmarks: () => {
        this.landmarks.clear();
        this.showLandmarks();
      },
      comparing: (comparing) => this.compare(comparing),
    });
    this.names = new Names(scene);
    new ResizeObserver(() => this.resize()).observe(this.stage.canvas);
    this.recolor();
    this.updateText();
    this.resize();
  }

  // ---- for scripts ----

  /** Pairs that are known already, as if they had been picked. */
  addLandmarks(pairs: readonly (readonly [number, number])[]): void {
    this.landmarks.pairs.push(...pairs.map(([source, target]): [number, number] => [source, target]));
    this.showLandmarks();
  }

  /** Where a vertex is on the page; of the target, where it is seen through a map (default: the current one). */
  screenPosition(side: Side, vertex: number, map = this.mapIndex): ScreenPoint {
    const point = this.stage.project(side === "source" ? 0 : this.paneOf(map), vertex);
    const box = this.stage.canvas.getBoundingClientRect();
    return { ...point, x: point.x + box.left, y: point.y + box.top };
  }

  /** The vertices marked on both meshes, under a map (default: the current one). */
  highlighted(map = this.mapIndex): Record<Side, number[]> {
    const selection = this.hovered ?? this.pinned;
    if (!selection) return { source: [], target: [] };
    if (selection.side === "target") {
      const sources = this.correspondences[selection.map ?? map].sourcesOf(selection.vertex);
      if ((selection.map ?? map) === map) return { source: sources, target: [selection.vertex] };
      const images = sources.map((v) => this.correspondences[map].map.image[v]).filter((image) => image >= 0);
      return { source: sources, target: [...new Set(images)] };
    }
    const image = this.correspondences[map].map.image[selection.vertex];
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

  /** The maps that are seen now, one pane of the target each. */
  private shownMaps(): number[] {
    return this.isComparing ? [...this.correspondences.keys()].slice(0, maxCompared) : [this.mapIndex];
  }

  private paneOf(map: number): number {
    return Math.max(this.shownMaps().indexOf(map), 0) + 1;
  }

  private panes(): Pane[] {
    const targets = this.shownMaps().map((_, i) => {
      this.targets[i] ??= new Surface(this.scene.target, this.targets[0].upright, this.targets[0], () => this.requestFrame());
      return { side: "target" as const, surface: this.targets[i] };
    });
    return [{ side: "source", surface: this.source }, ...targets];
  }

  private compare(comparing: boolean): void {
    this.isComparing = comparing;
    this.stage.panes = this.panes();
    this.names.showMaps(comparing ? this.shownMaps() : []);
    this.names.place(this.stage);
    this.recolor();
  }

  private pick(x: number, y: number): Selection | null {
    const picked = this.stage.pick(x, y);
    if (!picked) return null;
    const { pane, vertex } = picked;
    return pane === 0 ? { side: "source", vertex } : { side: "target", vertex, map: this.shownMaps()[pane - 1] };
  }

  private highlight(selection: Selection | null): void {
    const before = this.hovered;
    if (selection?.side === before?.side && selection?.vertex === before?.vertex && selection?.map === before?.map) return;
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

  private showLandmarks(): void {
    this.panel.showLandmarks(this.landmarks.pairs.length, this.landmarks.isWaiting ? "now its counterpart" : "");
    // For a page that matches again with them.
    window.dispatchEvent(new CustomEvent("landmarks", { detail: this.landmarks.pairs }));
    this.requestFrame("overlay");
  }

  private updateMorph(): void {
    if (this.morph > 0 && this.goalMap !== this.mapIndex) {
      this.goalMap = this.mapIndex;
      const rotation = new Quaternion().fromArray(this.scene.sourceFromTarget);
      this.source.setGoal(...morphGoal(this.source, this.targets[0], this.current.map.image, rotation));
    }
    this.source.morph = this.morph;
    this.requestFrame();
  }

  // ---- colors ----

  private recolor(): void {
    const { field, top, bandWidth } = this.sourceField(this.current);
    const cells = this.checkerCells();
    this.source.show(this.mode, field, top, bandWidth, cells);
    this.shownMaps().forEach((map, i) => {
      const shown = this.correspondences[map];
      const own = this.sourceField(shown).field;
      const carried = own ? carry(own, shown.map.image, this.targets[i].topology) : null;
      this.targets[i].show(this.mode, carried, top, bandWidth, cells);
    });
    this.updateLegend(top, bandWidth);
    this.requestFrame();
  }

  private sourceField({ map }: Correspondence): { field: Field | null; top: number; bandWidth: number } {
    switch (this.mode) {
      case "colors":
      case "checker":
        return { field: positionField(this.scene.source.positions, map.image), top: 1, bandWidth: 1 };
      case "error": {
        const error = map.error ?? new Float32Array(map.image.length).fill(NaN);
        return { field: scalarField(error, (v) => !Number.isNaN(error[v])), top: this.errorTop(), bandWidth: 1 };
      }
      case "frontiers": {
        const levels = this.source.topology.levels(this.base);
        const top = levels.reduce((a, b) => Math.max(a, b), 1);
        const field = scalarField(levels, (v) => levels[v] >= 0);
        return { field, top, bandWidth: Math.max(1, Math.round(top / frontierBands)) };
      }
      case "values": {
        const { range: [low, high], of } = this.values[this.valuesIndex];
        const values = of(map) ?? new Float32Array(map.image.length).fill(NaN);
        const scaled = values.map((value) => (value - low) / (high - low || 1));
        return { field: scalarField(scaled, (v) => Number.isFinite(values[v])), top: 1, bandWidth: 1 };
      }
      case "plain":
      case "texture":
        return { field: null, top: 1, bandWidth: 1 };
    }
  }

  /** One scale for all maps, so that they can be compared. */
  private errorTop(): number {
    if (this.errorEnd !== null) return this.errorEnd;
    return Math.max(...this.correspondences.filter(({ map }) => map.error).map((c) => c.errorScale()), 1e-6);
  }

  /** Cells of the checkerboard along each axis. */
  private checkerCells(): Vector3 {
    const size = new Vector3().subVectors(...this.source.box());
    const longest = Math.max(size.x, size.y, size.z);
    return size.divideScalar(longest / 12);
  }

  // ---- words ----

  private updateText(): void {
    const selection = this.hovered ?? this.pinned;
    element("stats").replaceChildren(...summarize(this.current));
    this.panel.showWarnings(this.current.map.warnings);
    const words = describe(selection, this.current, this.correspondences, this.scene);
    const answer = element("answer");
    answer.replaceChildren(...words.flatMap((word) => [word, " "]));
    answer.title = answer.textContent ?? ""; // whole, where it is too long for its place
    this.panel.showVertex(this.highlighted().source[0] ?? null);
  }

  private updateLegend(top: number, bandWidth: number): void {
    const legend = element("legend");
    if (this.mode === "error") legend.replaceChildren(...errorLegend(top));
    else if (this.mode === "values")
      legend.replaceChildren(...valueLegend(this.values[this.valuesIndex], this.current.map));
    else if (this.mode === "frontiers") legend.replaceChildren(...levelLegend(this.base, top, bandWidth));
    else legend.replaceChildren(...colorLegend());
    const complete =
      this.current.matched === this.scene.source.vertexCount && this.current.covered === this.scene.target.vertexCount;
    legend.hidden =
      this.mode === "plain" || this.mode === "texture" || ((this.mode === "colors" || this.mode === "checker") && complete);
  }

  // ---- drawing ----

  private resize(): void {
    if (!this.stage.resize()) return;
    this.overlay.resize();
    this.names.place(this.stage);
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
        this.highlight(this.pick(x, y));
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
    const markers: Marker[] = [];
    const mark = (pane: number, vertex: number, color: string, shape: Marker["shape"]) =>
      markers.push({ at: this.stage.project(pane, vertex), color, shape });
    const { source, target } = this.highlighted();
    const shown = source.slice(0, maxMarkers);
    const truth = shown.length > 0 ? (this.scene.truth?.[shown[0]] ?? -1) : -1;
    for (const v of shown) mark(0, v, sourceColor, "disc");
    for (const map of this.shownMaps()) {
      const pane = this.paneOf(map);
      if (truth >= 0) mark(pane, truth, truthColor, "ring");
      for (const v of this.highlighted(map).target) mark(pane, v, targetColor, "disc");
      for (const [, to] of this.landmarks.pairs) mark(pane, to, truthColor, "ring");
    }
    for (const [from] of this.landmarks.pairs) mark(0, from, truthColor, "ring");
    let link: Line | null = null;
    if (shown.length > 0 && target.length > 0)
      link = this.line(shown[0], target[0], getComputedStyle(document.body).color);
    this.overlay.draw(this.sampleLines(), link, markers);
  }

  private line(from: number, to: number, color: string): Line {
    return { from: this.stage.project(0, from), to: this.stage.project(this.paneOf(this.mapIndex), to), color };
  }

  private sampleLines(): Line[] {
    const { map } = this.current;
    const [high, low] = this.source.box();
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
