// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/vector_lanes.hpp"

namespace counterpart::numerics {

template <class Kernel, class... Arguments>
void run_4(Arguments... arguments) {
    Kernel::template run<4>(arguments...);
}
#ifdef COUNTERPART_WIDE_VECTORS
template <class Kernel, class... Arguments>
[[gnu::target("avx2")]] void run_8(Arguments... arguments) {
    Kernel::template run<8>(arguments...);
}
template <class Kernel, class... Arguments>
[[gnu::target("avx512f")]] void run_16(Arguments... arguments) {
    Kernel::template run<16>(arguments...);
}
#endif

template <class Kernel, class... Arguments>
auto widest_with(void (*)(Arguments...)) -> void (*)(Arguments...) {  // the arguments of `run`
#ifdef COUNTERPART_WIDE_VECTORS
    if (vector_lanes() == 16) return run_16<Kernel, Arguments...>;
    if (vector_lanes() == 8) return run_8<Kernel, Arguments...>;
#endif
    return run_4<Kernel, Arguments...>;
}

/// `Kernel::run<lanes>` compiled for the widest vectors that this machine has. `run` must be `always_inline`,
/// or its body is compiled for the baseline machine; its result must not depend on `lanes`.
template <class Kernel>
auto widest() {
    return widest_with<Kernel>(&Kernel::template run<4>);
}

}  // namespace counterpart::numerics
