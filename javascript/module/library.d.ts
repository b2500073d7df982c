// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
// library.js, which Emscripten makes of javascript/src.
import type { MakeCore } from "./core.js";

declare const makeCore: MakeCore;
export default makeCore;
