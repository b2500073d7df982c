// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once
#if __clang_major__ < 15
// Comes before every file of the WebAssembly build. An exception finds its handler through this variable,
// of which libunwind has one for each thread. Clang before 15 takes it for one of all threads, unless the
// file has declared and used it. CMakeLists.txt links the variable.
struct _Unwind_LandingPadContext;
extern "C" {
extern __thread _Unwind_LandingPadContext __wasm_lpad_context __attribute__((tls_model("local-exec")));
__attribute__((used, visibility("hidden"))) inline void* counterpart_landing_pad_context() {
    return &__wasm_lpad_context;
}
}
#endif
