// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// How the program says what the library tells of a map: the verdict, its causes, and messages.
#pragma once

#include "load_map.hpp"

#include <counterpart/match/verdict.hpp>

#include <string>
#include <vector>

namespace counterpart::cli {

/// What is known of a map that a command found.
struct Judgment {
    std::vector<Message> messages;  ///< that the verdict follows from
    std::vector<Message> causes;    ///< the likeliest first

    Verdict verdict() const { return counterpart::verdict(messages); }
    /// What every report of a command that matches holds.
    Json report() const;
};

/// Says the verdict and the causes, unless --quiet.
void say_verdict(const CommonOptions& options, const Judgment& judgment, const MeshPair& pair);

/// Says notices, unless --quiet, and warns of the others; messages on a mesh name its file.
void say_messages(const CommonOptions& options, const std::vector<Message>& messages, const MeshPair& pair);

/// The sentence, with the file's name before it if it is about a mesh.
std::string named(const Message& message, const MeshPair& pair);

Json to_json(const std::vector<Message>& messages);

}  // namespace counterpart::cli
