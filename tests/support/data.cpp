// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/data.hpp"

#include <cstdlib>

namespace counterpart::test {

std::filesystem::path data_folder() {
    const char* named = std::getenv("COUNTERPART_DATA");
    return named != nullptr ? named : COUNTERPART_DEFAULT_DATA;
}

}  // namespace counterpart::test
