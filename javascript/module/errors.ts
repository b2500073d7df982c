// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
/** What the library throws, by the same names and with the same sentences as in C++ and Python. */
export class CounterpartError extends Error {
  override readonly name: string = "CounterpartError";
}
/** The caller's data or options cannot be used; the message names the element and what to do about it. */
export class InvalidInput extends CounterpartError {
  override readonly name: string = "InvalidInput";
}
/** A valid mesh that this method cannot handle; another method may. */
export class UnsuitableMesh extends InvalidInput {
  override readonly name = "UnsuitableMesh";
}
/** A file cannot be read or written; the message names the file, the line where there is one, and the reason. */
export class IoError extends CounterpartError {
  override readonly name = "IoError";
}
/** A computation on valid input failed. */
export class NumericalError extends CounterpartError {
  override readonly name = "NumericalError";
}
/** The caller stopped the work. */
export class Canceled extends CounterpartError {
  override readonly name = "Canceled";
}
/** WebAssembly has 4 GB at most. */
export class OutOfMemory extends CounterpartError {
  override readonly name = "OutOfMemory";
}

const classes: Record<string, new (message: string) => CounterpartError> = {
  InvalidInput,
  UnsuitableMesh,
  IoError,
  NumericalError,
  Canceled,
  OutOfMemory,
};

/** The error of a name and a message, as they come from the library or from a worker. */
export function errorOf(kind: string, message: string): CounterpartError {
  return new (classes[kind] ?? CounterpartError)(message);
}
