// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Example, MatchOptions, MatchResult, MeshObject, Message, Pair } from "counterpart3d";
import { Canceled } from "counterpart3d";
import { type RemoteCounterpart, type RemoteMesh, startWorker } from "counterpart3d/worker";
import { listenForFiles, type MeshFiles, meshesAmong, readFiles, save } from "./files";
import { isolate } from "./isolation";
import { offerObjects } from "./objects";
import { showScene } from "./view";
import { sizeOf, summaryOf, timeLeft } from "./words";

const sides = ["source", "target"] as const;
type Side = (typeof sides)[number];

function element<Kind extends HTMLElement = HTMLElement>(id: string): Kind {
  return document.getElementById(id) as Kind;
}
const valueOf = (id: string) => element<HTMLSelectElement>(id).value;
const isChecked = (id: string) => element<HTMLInputElement>(id).checked;

/** Holds what was dropped and found, and keeps the page to it. */
class Page {
  private isUsed = false;
  private readonly library: Promise<RemoteCounterpart> = isolate(() => !this.isUsed).then(() => startWorker());
  private readonly files: Partial<Record<Side, MeshFiles>> = {};
  private readonly meshes: Partial<Record<Side, RemoteMesh>> = {};
  /** Those that the map was found with, and those that are picked now. */
  private used: readonly Pair[] = [];
  private landmarks: readonly Pair[] = [];
  private running: AbortController | null = null;
  private result: MatchResult | null = null;

  constructor() {
    this.nameFormats().catch((error) => this.fail(error));
    for (const side of sides) {
      const input = element<HTMLInputElement>(`${side}-file`);
      listenForFiles(element(`${side}-drop`), input, (files) => void this.take(side, files));
      const object = `${side}-object`;
      element(object).addEventListener("change", () => void this.read(side, this.files[side]!, valueOf(object)));
    }
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-example]")) {
      button.addEventListener("click", () => void this.takeExample(button.dataset.example as Example));
    }
    element("input").addEventListener("submit", (event) => {
      event.preventDefault();
      void this.match([]);
    });
    element("cancel").addEventListener("click", () => this.running?.abort());
    element("match-again").addEventListener("click", () => void this.match(this.landmarks));
    element("save-map").addEventListener("click", () => this.saveMap());
    element("save-reordered").addEventListener("click", () => void this.saveReordered());
    element("save-glb").addEventListener("click", () => void this.saveTransferred());
  }

  private async nameFormats(): Promise<void> {
    const { read } = await (await this.library).extensions();
    element("formats").textContent =
      `Reads ${read.join(", ")}. Drop the files that a mesh names, such as pictures, together with it.`;
  }

  // ---- what is matched ----

  /** Two meshes at once are source and target, wherever they are dropped. */
  private async take(side: Side, files: File[]): Promise<void> {
    this.isUsed = true;
    element(`${side}-name`).textContent = "reading ...";
    const found = meshesAmong(files, (await (await this.library).extensions()).read);
    for (const [i, each] of (found.length > 1 ? sides : [side]).entries()) await this.read(each, found[i], "");
  }

  /** `object`: of the file, or the whole if it is empty. */
  private async read(side: Side, files: MeshFiles, object: string): Promise<void> {
    this.running?.abort();
    this.clear();
    element(`${side}-name`).textContent = `reading ${files.mesh.name} ...`;
    try {
      const library = await this.library;
      this.release(side, library);
      const mesh = await readFiles(library, files, object);
      this.hold(side, mesh);
      this.files[side] = files;
      if (object === "") this.offer(side, mesh.objects);
    } catch (error) {
      if (object === "") this.offer(side, []);
      element(`${side}-name`).textContent = "Drop a mesh here, or choose a file";
      this.fail(error);
    }
    this.update();
  }

  private async takeExample(kind: Example): Promise<void> {
    this.isUsed = true;
    this.running?.abort();
    this.clear();
    try {
      const library = await this.library;
      for (const side of sides) this.release(side, library);
      for (const side of sides) this.offer(side, []);
      const pair = await library.example(kind);
      for (const [i, side] of sides.entries()) this.hold(side, pair[i]);
      await this.match([]);
    } catch (error) {
      this.fail(error);
    }
  }

  private release(side: Side, library: RemoteCounterpart): void {
    if (this.meshes[side]) library.free(this.meshes[side]);
    delete this.meshes[side];
  }

  private offer(side: Side, objects: readonly MeshObject[]): void {
    offerObjects(element<HTMLSelectElement>(`${side}-object`), objects);
  }

  private hold(side: Side, mesh: RemoteMesh): void {
    this.meshes[side] = mesh;
    element(`${side}-name`).textContent = [`${mesh.name}: ${sizeOf(mesh)}`, ...mesh.notices].join(". ");
  }

  // ---- matching ----

  private options(landmarks: readonly Pair[]): MatchOptions {
    return {
      method: valueOf("method") as NonNullable<MatchOptions["method"]>,
      part: valueOf("part") as NonNullable<MatchOptions["part"]>,
      sameScale: isChecked("same-scale"),
      aligned: isChecked("aligned"),
      allowMirror: isChecked("allow-mirror"),
      ...(landmarks.length > 0 && { landmarks }),
    };
  }

  private async match(landmarks: readonly Pair[]): Promise<void> {
    const { source, target } = this.meshes;
    if (!source || !target || (this.running && !this.running.signal.aborted)) return;
    this.clear();
    this.used = landmarks;
    const running = (this.running = new AbortController());
    this.update();
    const start = performance.now();
    const seconds = () => (performance.now() - start) / 1000;
    try {
      const library = await this.library;
      this.result = await library.match(source, target, {
        ...this.options(landmarks),
        signal: running.signal,
        onProgress: (fraction) => {
          element<HTMLProgressElement>("bar").value = fraction;
          element("left").textContent = timeLeft(fraction, seconds());
        },
      });
      this.say(this.result, seconds());
      const { targetFromSource, confidence, runnerUps } = this.result;
      const maps = [{ targetFromSource, description: "match" }, ...runnerUps];
      const scene = await library.viewerScene(source, target, maps, confidence);
      if (!running.signal.aborted)
        await showScene(element<HTMLIFrameElement>("viewer"), scene, landmarks, (pairs) => this.hear(pairs));
    } catch (error) {
      if (!running.signal.aborted) this.fail(error);
    }
    if (this.running !== running) return; // another has begun
    this.running = null;
    this.update();
  }

  private hear(pairs: readonly Pair[]): void {
    this.landmarks = pairs;
    const again = element("match-again");
    again.hidden = String(pairs) === String(this.used);
    again.textContent = `Match again with ${pairs.length || "no"} ${pairs.length === 1 ? "landmark" : "landmarks"}`;
  }

  // ---- downloads ----

  private saveMap(): void {
    if (this.result) save("map.txt", [...this.result.targetFromSource, ""].join("\n"));
  }

  private async saveReordered(): Promise<void> {
    const { source, target } = this.meshes;
    await this.saving(async (library) => {
      const mesh = await library.reorder(source!, target!, { allowMirror: isChecked("allow-mirror") });
      const name = /\.(off|obj|ply|gltf|glb)$/i.test(target!.name) ? target!.name : `${target!.name}.obj`;
      const written = `reordered_${name.replace(/\.gltf$/i, ".glb")}`;
      save(written, await library.writeMesh(mesh, written));
      library.free(mesh);
    });
  }

  private async saveTransferred(): Promise<void> {
    const { source, target } = this.meshes;
    await this.saving(async (library) => {
      const { mesh, messages } = await library.transfer(source!, target!, this.result!.targetFromSource);
      this.listMessages("messages", [...this.result!.messages, ...messages]);
      save("transferred.glb", await library.writeMesh(mesh, "transferred.glb"));
      library.free(mesh);
    });
  }

  private async saving(work: (library: RemoteCounterpart) => Promise<void>): Promise<void> {
    try {
      await work(await this.library);
    } catch (error) {
      this.fail(error);
    }
  }

  // ---- words ----

  private say(result: MatchResult, seconds: number): void {
    const verdict = element("verdict");
    verdict.textContent = result.verdict;
    verdict.className = result.verdict.replaceAll(" ", "-");
    element("verdict-reason").textContent = result.verdictReason;
    element("summary").textContent = summaryOf(result, seconds);
    this.listMessages("causes", result.causes);
    element("causes-box").hidden = result.causes.length === 0;
    this.listMessages("messages", result.messages);
    element("messages-box").hidden = result.messages.length === 0;
    const reordered = element<HTMLButtonElement>("save-reordered");
    reordered.disabled = !result.isSameConnectivity;
    reordered.title = reordered.disabled
      ? "Only meshes of the same connectivity have a common order"
      : "The target's shape in the source's vertex order";
    const glb = element<HTMLButtonElement>("save-glb");
    const { attributes } = this.meshes.source!;
    glb.disabled = attributes.length === 0;
    glb.title = glb.disabled
      ? "The source has no colors, textures, skin or morph targets"
      : `The target with the source's ${attributes.join(", ")}`;
    element("result").hidden = false;
  }

  private listMessages(id: string, messages: readonly Message[]): void {
    const items = messages.map(({ severity, subject, sentence }) => {
      const item = document.createElement("li");
      item.className = severity.replaceAll(" ", "-");
      item.textContent = subject === "map" ? sentence : `${this.meshes[subject]!.name}: ${sentence}`;
      return item;
    });
    element(id).replaceChildren(...items);
  }

  private fail(error: unknown): void {
    if (error instanceof Canceled) return;
    element("error").textContent = error instanceof Error ? error.message : String(error);
    element("error").hidden = false;
  }

  private clear(): void {
    for (const id of ["error", "result", "viewer", "match-again"]) element(id).hidden = true;
    element("viewer").removeAttribute("src");
    this.result = null;
  }

  private update(): void {
    const isRunning = this.running !== null;
    element<HTMLButtonElement>("match").disabled = isRunning || !this.meshes.source || !this.meshes.target;
    element("cancel").hidden = !isRunning;
    element("progress").hidden = !isRunning;
    element<HTMLProgressElement>("bar").removeAttribute("value");
    element("left").textContent = "";
  }
}

new Page();
