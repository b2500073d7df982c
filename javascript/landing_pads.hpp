// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once
#if __clang_major__ < 15
// Included before every file of the WebAssembly build (CMakePresets.json). An exception finds its handler through this variable
// of Emscripten's libunwind, which has one for each thread. Clang before 15 takes it for one of all threads, so that what is
// thrown finds no handler, unless the file has declared it, and uses it. CMakeLists.txt links the variable.
struct _Unwind_LandingPadContext;
extern "C" {
extern __thread _Unwind_LandingPadContext __wasm_lpad_context __attribute__((tls_model("local-exec")));
__attribute__((used, visibility("hidden"))) inline void* counterpart_landing_pad_context() {
    return &__wasm_lpad_context;
}
}
#endif
