// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
/** Which point of mesh B is this point of mesh A? The library `counterpart` in WebAssembly, for Node.js, workers and pages. */
import { Counterpart } from "./counterpart.js";
import { IoError } from "./errors.js";
import makeCore from "./library.js";

export * from "./counterpart.js";
export * from "./errors.js";
export { Mesh } from "./mesh.js";
export * from "./types.js";

/** Compiles the library once; hand it to `load` and `startWorker`. `from`: the bytes of library.wasm, or its address,
 * by default beside this file. */
export async function compile(
  from: URL | BufferSource = new URL("./library.wasm", import.meta.url),
): Promise<WebAssembly.Module> {
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

/** The library, ready to be called. */
export async function load(module?: WebAssembly.Module): Promise<Counterpart> {
  const compiled = module ?? (await compile());
  const core = await makeCore({
    instantiateWasm(imports, receive) {
      void WebAssembly.instantiate(compiled, imports).then(receive);
      return {};
    },
  });
  return new Counterpart(core);
}
