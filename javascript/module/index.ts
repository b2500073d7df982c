// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
/** Which point of mesh B is this point of mesh A? The library `counterpart` in WebAssembly, for Node.js, workers and pages. */
import type { Core, InstantiateWasm, MakeCore } from "./core.js";
import { Counterpart } from "./counterpart.js";
import { IoError } from "./errors.js";
import makeCore from "./library.js";

export * from "./counterpart.js";
export * from "./errors.js";
export { Mesh } from "./mesh.js";
export * from "./types.js";

/** The library's bytes: those for one thread or, for a worker of a page that shares memory between its threads, for all. */
export function libraryAddress(hasThreads = false): URL {
  return hasThreads ? new URL("./library_threads.wasm", import.meta.url) : new URL("./library.wasm", import.meta.url);
}

/** Compiles the library once; hand it to `load` and `startWorker`. `from`: the bytes of library.wasm, or its address. */
export async function compile(from: URL | BufferSource = libraryAddress()): Promise<WebAssembly.Module> {
  if (!(from instanceof URL)) return WebAssembly.compile(from);
  if (from.protocol === "file:") {
    const { readFile } = await import(/* @vite-ignore */ "node:" + "fs/promises");
    return WebAssembly.compile(await readFile(from));
  }
  const response = await fetch(from);
  if (!response.ok) throw new IoError(`${from.href}: cannot be loaded (${response.status})`);
  if (response.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Threads share a memory that is given to the library; one thread has its own. */
function hasThreads(module: WebAssembly.Module): boolean {
  return WebAssembly.Module.imports(module).some(({ kind }) => kind === "memory");
}

/** Its threads load these files by themselves. */
async function makeCoreWithThreads(instantiateWasm: InstantiateWasm): Promise<Core> {
  const script = new URL("./library_threads.js", import.meta.url).href;
  const worker = new URL("./library_threads.worker.js", import.meta.url).href;
  const { default: make } = (await import(/* @vite-ignore */ script)) as { default: MakeCore };
  return make({ instantiateWasm, mainScriptUrlOrBlob: script, locateFile: () => worker });
}

/** The library, ready to be called. */
export async function load(module?: WebAssembly.Module): Promise<Counterpart> {
  const compiled = module ?? (await compile());
  const instantiate: InstantiateWasm = (imports, receive) => {
    void WebAssembly.instantiate(compiled, imports).then((instance) => receive(instance, compiled));
    return {};
  };
  const make = hasThreads(compiled) ? makeCoreWithThreads : (way: InstantiateWasm) => makeCore({ instantiateWasm: way });
  return new Counterpart(await make(instantiate));
}
