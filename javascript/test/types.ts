// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// Compiled, never run: what the declarations let pass, and what not.
import { type Counterpart, InvalidInput, load, type MatchResult, type Mesh } from "counterpart3d";
import { type RemoteCounterpart, startWorker } from "counterpart3d/worker";

const counterpart: Counterpart = await load();
const a: Mesh = counterpart.readMesh("a.obj", new Uint8Array());
const arrays = { vertices: [0, 0, 0], triangles: [] };
const result: MatchResult = counterpart.match(a, arrays, { method: "spectral", up: "y", landmarks: [[0, 1]] });
const image: number = result.targetFromSource[0];
const error: Error = new InvalidInput(String(image));
const remote: RemoteCounterpart = await startWorker();
const [b, c] = await remote.example("part");
const promised: Promise<MatchResult> = remote.match(b, c, { signal: new AbortController().signal });
const names: string[] = a.objects.map(({ name }) => name);
// @ts-expect-error: no such method
counterpart.match(a, a, { method: "best" });
// @ts-expect-error: a landmark is a pair
counterpart.match(a, a, { landmarks: [[1]] });
// @ts-expect-error: what a mesh holds is its own
a.content;

export { error, names, promised };
