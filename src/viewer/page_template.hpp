// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace counterpart::viewer {

/// viewer/dist/viewer.html, the built viewer, compiled in by cmake/ViewerPage.cmake.
std::string_view page_template();

}  // namespace counterpart::viewer
