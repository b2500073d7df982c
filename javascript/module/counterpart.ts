// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { Content, Core, Outcome } from "./core.js";
import { errorOf, InvalidInput } from "./errors.js";
import { makeFolder, withFiles } from "./files.js";
import { Mesh } from "./mesh.js";
import type {
  Evaluation,
  Extensions,
  MatchOptions,
  MatchResult,
  Message,
  Progress,
  ReadOptions,
  ReorderOptions,
  RunnerUp,
  TransferredAttribute,
  ViewerScene,
} from "./types.js";

/** A mesh as it was read, or its arrays. */
export type MeshLike = Mesh | { vertices: ArrayLike<number>; triangles: ArrayLike<number> };

/** What `example` makes: the same body bent and renumbered, remeshed too, or only a part of that. */
export type Example = "shuffled" | "remeshed" | "part";

function valueOf<Value>(outcome: Outcome<Value>): Value {
  if ("error" in outcome) throw errorOf(outcome.error.kind, outcome.error.message);
  return outcome.value;
}

/** The library, loaded. Its functions keep the thread that calls them busy until they are done: in a page call them from a worker
 * (`startWorker`). */
export class Counterpart {
  /** @internal */
  constructor(private readonly core: Core) {
    makeFolder(core.FS);
  }

  /** Endings of the files that `readMesh` reads and `writeMesh` writes, with their dots. */
  extensions(): Extensions {
    return this.core.extensions();
  }

  /** Bytes of memory that the library has taken so far; it keeps them. */
  get memory(): number {
    return this.core.HEAPU8.length;
  }

  /** Reads a mesh with its attributes from the bytes of a file; the name's ending tells the format. Throws IoError. */
  readMesh(name: string, bytes: Uint8Array, options: ReadOptions = {}): Mesh {
    const { beside = {}, strict = false, object = null } = options;
    return withFiles(this.core.FS, { ...beside, [name]: bytes }, () => {
      const last = name.replace(/.*[\\/]/, "");
      return new Mesh(last, valueOf(this.core.readContent(last, strict, object)));
    });
  }

  /** A mesh of arrays: three coordinates for each vertex, three vertices for each triangle. Throws InvalidInput. */
  makeMesh(vertices: ArrayLike<number>, triangles: ArrayLike<number>, name = "mesh"): Mesh {
    return new Mesh(name, valueOf(this.core.contentOf(Float64Array.from(vertices), Int32Array.from(triangles))));
  }

  /** The bytes of a file; the name's ending tells the format, which leaves out what it cannot hold. Throws IoError. */
  writeMesh(mesh: MeshLike, name: string): Uint8Array {
    return this.borrow([mesh], ([content]) =>
      withFiles(this.core.FS, {}, (read) => {
        valueOf(this.core.writeContent(content, name.replace(/.*[\\/]/, "")));
        return read(name);
      }),
    );
  }

  /** Which target vertex is each source vertex? Throws InvalidInput, UnsuitableMesh, NumericalError, Canceled. */
  match(source: MeshLike, target: MeshLike, options: MatchOptions = {}): MatchResult {
    const { onProgress, initial, ...others } = options;
    return this.borrow([source, target], ([a, b]) =>
      reporting(onProgress, (step) => this.core.match(a, b, JSON.stringify(others), initial ?? null, step)),
    );
  }

  /** The target's shape in the source's order. Throws InvalidInput if the meshes have different connectivity. */
  reorder(source: MeshLike, target: MeshLike, options: ReorderOptions = {}): Mesh {
    const { allowMirror = false, weldDistance = -1 } = options;
    return this.borrow(
      [source, target],
      ([a, b]) => new Mesh("reordered", valueOf(this.core.reorder(a, b, allowMirror, weldDistance))),
    );
  }

  /** The target with the source's attributes: colors, texture coordinates, normals, skin, morph targets, materials. */
  transfer(
    source: MeshLike,
    target: MeshLike,
    targetFromSource: Int32Array,
    options: { onProgress?: Progress } = {},
  ): { mesh: Mesh; attributes: TransferredAttribute[]; messages: Message[] } {
    return this.borrow([source, target], ([a, b]) => {
      const { content, ...rest } = reporting(options.onProgress, (step) => this.core.transfer(a, b, targetFromSource, step));
      return { mesh: new Mesh("transferred", content), ...rest };
    });
  }

  /** Errors of a map where the true one is known (-1: unknown). Throws InvalidInput. */
  evaluate(source: MeshLike, target: MeshLike, targetFromSource: Int32Array, truth: Int32Array): Evaluation {
    return this.borrow([source, target], ([a, b]) => valueOf(this.core.evaluate(a, b, targetFromSource, truth)));
  }

  /** What `counterpart view` shows, for a page that holds the viewer. */
  viewerScene(
    source: MeshLike,
    target: MeshLike,
    maps: readonly RunnerUp[],
    confidence: Float64Array = new Float64Array(),
  ): ViewerScene {
    const nameOf = (mesh: MeshLike, otherwise: string) => (mesh instanceof Mesh ? mesh.name : otherwise);
    return this.borrow([source, target], ([a, b]) =>
      valueOf(this.core.viewerScene(a, b, nameOf(source, "source"), nameOf(target, "target"), maps, confidence)),
    );
  }

  /** Two meshes to try things with, always the same. */
  example(kind: Example): [Mesh, Mesh] {
    const [source, target] = valueOf(this.core.example(kind));
    return [new Mesh("body", source), new Mesh(kind, target)];
  }

  /** Runs `work` on what the library holds of these meshes; arrays are handed over for so long. */
  private borrow<Result>(meshes: readonly MeshLike[], work: (contents: Content[]) => Result): Result {
    const held: Mesh[] = [];
    try {
      const contents = meshes.map((mesh) => {
        if (mesh instanceof Mesh) return mesh.content;
        if (!mesh?.vertices || !mesh.triangles) throw new InvalidInput("a mesh must have vertices and triangles");
        held.push(this.makeMesh(mesh.vertices, mesh.triangles));
        return held[held.length - 1].content;
      });
      return work(contents);
    } finally {
      for (const mesh of held) mesh.free();
    }
  }
}

/** Runs `work` with a progress callback that no exception leaves: what it throws cancels, and is thrown afterwards. */
function reporting<Value>(
  progress: Progress | undefined,
  work: (step: ((fraction: number) => boolean) | null) => Outcome<Value>,
): Value {
  if (!progress) return valueOf(work(null));
  let thrown: { error: unknown } | null = null;
  const outcome = work((fraction) => {
    try {
      return progress(fraction) !== false;
    } catch (error) {
      thrown = { error };
      return false;
    }
  });
  if (thrown) throw (thrown as { error: unknown }).error;
  return valueOf(outcome);
}
