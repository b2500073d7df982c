// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

namespace counterpart::cli {

/// From here on Ctrl-C (SIGINT) and SIGTERM cancel the work at its next progress report; work that does not
/// report within a second ends with interrupted_code all the same. Outputs are whole or absent either way.
/// Writing to a closed pipe fails (ClosedPipe) and does not end the program.
void cancel_on_interrupt();
/// Whether the user has interrupted the program.
bool is_interrupted();

}  // namespace counterpart::cli
