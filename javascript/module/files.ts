// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import type { FileSystem } from "./core.js";
import { IoError } from "./errors.js";

const folder = "/files";

/** The name of a file without its folders; it is all that messages say of it. */
function plain(name: string): string {
  const last = name.split(/[\\/]/).pop() ?? "";
  if (last === "" || last === "." || last === "..") throw new IoError(`'${name}' is no name of a file`);
  return last;
}

/** Runs `work` where these files are, and nothing else; removes them afterwards with all that the work wrote. */
export function withFiles<Result>(
  system: FileSystem,
  files: Readonly<Record<string, Uint8Array>>,
  work: (read: (name: string) => Uint8Array) => Result,
): Result {
  system.chdir(folder);
  try {
    for (const [name, bytes] of Object.entries(files)) system.writeFile(plain(name), bytes, { canOwn: true });
    return work((name) => system.readFile(plain(name)));
  } finally {
    for (const name of system.readdir(".")) if (name !== "." && name !== "..") system.unlink(name);
  }
}

export function makeFolder(system: FileSystem): void {
  system.mkdir(folder);
}
