// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace counterpart::base {

/// RFC 4648, section 4, with padding.
std::string to_base64(std::string_view bytes);

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
