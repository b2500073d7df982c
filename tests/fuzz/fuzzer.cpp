// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What libFuzzer calls (https://llvm.org/docs/LibFuzzer.html). The environment variable FUZZ_TARGET names the
// target: scripts/fuzz.sh sets it.
#include "fuzz/targets.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

const counterpart::fuzz::Target& chosen_target() {
    const char* name = std::getenv("FUZZ_TARGET");
    for (const counterpart::fuzz::Target& target : counterpart::fuzz::COUNTERPART_FUZZ_TARGETS())
        if (name != nullptr && target.name == name) return target;
    std::fprintf(stderr, "FUZZ_TARGET must name a target of this program\n");
    std::exit(1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const counterpart::fuzz::Target& target = chosen_target();
    target.run({reinterpret_cast<const char*>(data), size});
    return 0;
}
