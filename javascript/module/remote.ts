// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Example } from "./counterpart.js";
import { Canceled, errorOf, InvalidInput } from "./errors.js";
import { compile, libraryAddress } from "./index.js";
import type { Call, MeshMessage, Reply, Request } from "./messages.js";
import type {
  Evaluation,
  Extensions,
  MatchOptions,
  MatchResult,
  MeshObject,
  Message,
  Progress,
  ReadOptions,
  ReorderOptions,
  RunnerUp,
  TransferredAttribute,
  ViewerScene,
} from "./types.js";

/** A mesh that a worker holds. */
export interface RemoteMesh {
  readonly name: string;
  readonly vertices: Float64Array;
  readonly triangles: Int32Array;
  readonly notices: readonly string[];
  readonly attributes: readonly string[];
  readonly objects: readonly MeshObject[];
}

/** How to stop: work that is under way ends with its worker. */
export interface Stoppable {
  signal?: AbortSignal | undefined;
}

interface Pending {
  resolve(value: unknown): void;
  reject(error: Error): void;
  progress: Progress | undefined;
}

/** How a mesh came to be, to make it again in a new worker. */
interface Origin {
  call: Call;
  given: unknown[];
  /** Of what the call makes. */
  index?: number;
}

class Held implements RemoteMesh {
  worker: Worker | null;
  readonly name: string;
  readonly vertices: Float64Array;
  readonly triangles: Int32Array;
  readonly notices: readonly string[];
  readonly attributes: readonly string[];
  readonly objects: readonly MeshObject[];
  meshNumber: number;

  constructor(
    message: MeshMessage,
    worker: Worker | null,
    readonly origin: Origin | null,
  ) {
    ({
      name: this.name,
      vertices: this.vertices,
      triangles: this.triangles,
      notices: this.notices,
      attributes: this.attributes,
      objects: this.objects,
      meshNumber: this.meshNumber,
    } = message);
    this.worker = worker;
  }
}

/** Whether threads can share memory here: only in a page that is isolated from others (`crossOriginIsolated`). */
function canShareMemory(): boolean {
  if (!globalThis.crossOriginIsolated) return false;
  try {
    // As much as the library may come to need: some devices refuse it.
    return new WebAssembly.Memory({ initial: 1024, maximum: 65536, shared: true }).buffer.byteLength > 0;
  } catch {
    return false;
  }
}

/** Starts a worker that holds the library, with threads where they can share memory. `module`: from `compile`. */
export async function startWorker(module?: WebAssembly.Module): Promise<RemoteCounterpart> {
  return new RemoteCounterpart(module ?? (await compile(libraryAddress(canShareMemory()))));
}

/** The functions of Counterpart, run by a worker one after the other, so that the page stays alive. */
export class RemoteCounterpart {
  private worker: Worker | null = null;
  private readonly pending = new Map<number, Pending>();
  private nRequests = 0;

  constructor(private readonly module: WebAssembly.Module) {
    this.start();
  }

  extensions(): Promise<Extensions> {
    return this.ask("extensions", []) as Promise<Extensions>;
  }
  readMesh(name: string, bytes: Uint8Array, options: ReadOptions = {}): Promise<RemoteMesh> {
    return this.make({ call: "readMesh", given: [name, bytes, options] });
  }
  makeMesh(vertices: ArrayLike<number>, triangles: ArrayLike<number>, name = "mesh"): Promise<RemoteMesh> {
    return this.make({ call: "makeMesh", given: [Float64Array.from(vertices), Int32Array.from(triangles), name] });
  }
  async example(kind: Example): Promise<[RemoteMesh, RemoteMesh]> {
    const messages = (await this.ask("example", [kind])) as MeshMessage[];
    const [source, target] = messages.map(
      (mesh, index) => new Held(mesh, this.worker, { call: "example", given: [kind], index }),
    );
    return [source, target];
  }
  writeMesh(mesh: RemoteMesh, name: string): Promise<Uint8Array> {
    return this.ask("writeMesh", [mesh, name]) as Promise<Uint8Array>;
  }
  match(source: RemoteMesh, target: RemoteMesh, options: MatchOptions & Stoppable = {}): Promise<MatchResult> {
    const { onProgress, signal, ...others } = options;
    return this.ask("match", [source, target, others], onProgress, signal) as Promise<MatchResult>;
  }
  async reorder(source: RemoteMesh, target: RemoteMesh, options: ReorderOptions = {}): Promise<RemoteMesh> {
    return new Held((await this.ask("reorder", [source, target, options])) as MeshMessage, this.worker, null);
  }
  async transfer(
    source: RemoteMesh,
    target: RemoteMesh,
    targetFromSource: Int32Array,
    { onProgress, signal }: { onProgress?: Progress } & Stoppable = {},
  ): Promise<{ mesh: RemoteMesh; attributes: TransferredAttribute[]; messages: Message[] }> {
    const found = (await this.ask("transfer", [source, target, targetFromSource, {}], onProgress, signal)) as {
      mesh: MeshMessage;
      attributes: TransferredAttribute[];
      messages: Message[];
    };
    return { ...found, mesh: new Held(found.mesh, this.worker, null) };
  }
  evaluate(source: RemoteMesh, target: RemoteMesh, targetFromSource: Int32Array, truth: Int32Array): Promise<Evaluation> {
    return this.ask("evaluate", [source, target, targetFromSource, truth]) as Promise<Evaluation>;
  }
  viewerScene(
    source: RemoteMesh,
    target: RemoteMesh,
    maps: readonly RunnerUp[],
    confidence: Float64Array = new Float64Array(),
  ): Promise<ViewerScene> {
    return this.ask("viewerScene", [source, target, maps, confidence]) as Promise<ViewerScene>;
  }

  /** Gives a mesh's memory in the worker back. */
  free(mesh: RemoteMesh): void {
    if (mesh instanceof Held && mesh.worker === this.worker && this.worker) void this.send("free", [mesh.meshNumber]);
  }

  /** Ends the worker and what it does; a next call starts another. */
  stop(): void {
    this.worker?.terminate();
    this.worker = null;
    for (const { reject } of this.pending.values()) reject(new Canceled("canceled by the caller"));
    this.pending.clear();
  }

  private start(): Worker {
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    worker.postMessage(this.module);
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
    worker.onerror = (event) => {
      for (const { reject } of this.pending.values()) reject(errorOf("Failure", event.message || "the worker failed"));
      this.pending.clear();
      this.stop();
    };
    return (this.worker = worker);
  }

  private receive(reply: Reply): void {
    const pending = this.pending.get(reply.id);
    if (!pending) return;
    if ("progress" in reply) {
      if (pending.progress?.(reply.progress) === false) this.stop();
      return;
    }
    this.pending.delete(reply.id);
    if ("error" in reply) pending.reject(errorOf(reply.error.kind, reply.error.message));
    else pending.resolve(reply.value);
  }

  private async make(origin: Origin): Promise<RemoteMesh> {
    return new Held((await this.ask(origin.call, origin.given)) as MeshMessage, this.worker, origin);
  }

  /** Makes a mesh again if its worker has ended. */
  private async present(value: unknown): Promise<unknown> {
    if (!(value instanceof Held)) return value;
    if (value.worker !== this.worker || !this.worker) {
      if (!value.origin)
        throw new InvalidInput(`the mesh '${value.name}' has gone with the work that was canceled: make it again`);
      const { call, given, index } = value.origin;
      const made = await this.ask(call, given);
      value.meshNumber = (index === undefined ? (made as MeshMessage) : (made as MeshMessage[])[index]).meshNumber;
      value.worker = this.worker;
    }
    return { meshNumber: value.meshNumber };
  }

  private async ask(call: Call, given: unknown[], progress?: Progress, signal?: AbortSignal): Promise<unknown> {
    if (signal?.aborted) throw new Canceled("canceled by the caller");
    const values: unknown[] = [];
    for (const value of given) values.push(await this.present(value));
    const stop = () => this.stop();
    signal?.addEventListener("abort", stop, { once: true });
    try {
      return await this.send(call, values, progress);
    } finally {
      signal?.removeEventListener("abort", stop);
    }
  }

  private send(call: Request["call"], values: unknown[], progress?: Progress): Promise<unknown> {
    const worker = this.worker ?? this.start();
    const request: Request = { id: ++this.nRequests, call, arguments: values, reports: progress !== undefined };
    return new Promise((resolve, reject) => {
      this.pending.set(request.id, { resolve, reject, progress });
      worker.postMessage(request);
    });
  }
}
