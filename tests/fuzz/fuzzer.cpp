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
#include <ctime>

namespace {

// Of processor time, since what else the machine does is no fault of an input.
constexpr int most_seconds = 10;

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
    const std::clock_t start = std::clock();
    target.run({reinterpret_cast<const char*>(data), size});
    if (std::clock() - start > most_seconds * CLOCKS_PER_SEC) {
        std::fprintf(stderr, "took more than %d s of processor time\n", most_seconds);
        std::abort();
    }
    return 0;
}
