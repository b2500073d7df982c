// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// The program, built for this machine: makes the test's meshes, and what the package must say too.
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const program = process.env.COUNTERPART ?? fileURLToPath(new URL("../../build/release/counterpart", import.meta.url));
export const folder = mkdtempSync(join(tmpdir(), "counterpart_javascript_"));

export const bytesOf = (name) => readFileSync(join(folder, name));

export function run(...given) {
  return execFileSync(program, [...given, "-q"], { cwd: folder, encoding: "utf8" });
}

/** What it says of an error, without its own name before. */
export function refusal(...given) {
  const { status, stderr } = spawnSync(program, [...given, "-q"], { cwd: folder, encoding: "utf8" });
  return status === 0 ? "" : stderr.trim();
}

/** The map that the program finds. */
export function match(source, target, ...options) {
  run("match", source, target, "-o", "map.txt", ...options);
  return Int32Array.from(readFileSync(join(folder, "map.txt"), "utf8").trim().split("\n"), Number);
}

/** Processor seconds that the program takes. */
export function cost(...given) {
  const timed = 'TIMEFORMAT="%U %S"; time "$0" "$@"';
  const { stderr } = spawnSync("bash", ["-c", timed, program, ...given, "-q"], { cwd: folder, encoding: "utf8" });
  const [user, system] = stderr.trim().split("\n").at(-1).split(" ").map(Number);
  return user + system;
}
