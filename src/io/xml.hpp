// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace counterpart::io {

/// Parses XML into `document`, by pugixml, which knows no entities but the five of XML. Throws IoError with
/// the line.
void parse_xml(std::string_view text, const std::string& name, pugi::xml_document& document);

}  // namespace counterpart::io
