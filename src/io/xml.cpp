// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/xml.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::io {

void parse_xml(std::string_view text, const std::string& name, pugi::xml_document& document) {
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    if (result) return;
    const auto at =
        static_cast<std::ptrdiff_t>(std::min(static_cast<std::size_t>(result.offset), text.size()));
    throw IoError(fmt::format("{}:{}: the XML is damaged: {}", name,
                              1 + std::count(text.begin(), text.begin() + at, '\n'), result.description()));
}

}  // namespace counterpart::io
