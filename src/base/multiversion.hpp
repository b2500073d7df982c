// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

/// For functions whose loops gain from wider vectors: compiled for several instruction sets, the
/// best chosen when the program starts. Without contraction (see cmake/Warnings.cmake) and with sums kept in
/// a fixed number of lanes, every version computes the same bits.
/// Not for Windows, where GCC keeps wide vectors on a stack that is not aligned for them (its bug 54412).
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(_WIN32) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define COUNTERPART_MULTIVERSION __attribute__((target_clones("default", "avx2", "avx512f"), optimize("O3")))
#else
#define COUNTERPART_MULTIVERSION
#endif
