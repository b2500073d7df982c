// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace counterpart::base {

/// RFC 4648, section 4, with padding.
std::string to_base64(std::string_view bytes);

/// The bytes again, up to the first '='; blanks and line breaks are passed over. Nothing if there is anything
/// else.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace counterpart::base

namespace counterpart {
using namespace base;  // what every module is written with
}
