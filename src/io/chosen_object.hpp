// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/mesh_file.hpp>

#include <span>
#include <string>

namespace counterpart::io {

/// The number of the object that is meant: the one of that name or, if none has it, of that number. Throws
/// InvalidInput if several have the name, with their numbers, or none, with the names that there are.
Index chosen_object(std::span<const std::string> names, const std::string& wanted);

/// What a format without objects may be asked for: 0. Throws InvalidInput for all else.
void require_single_object(const std::string& wanted);

/// The object alone, and a notice that says which of how many. `file.content` has no document, which would
/// hold the others too.
void take_object(AttributedMeshFile& file, const std::string& wanted);

/// A sentence: which object of how many is read, and its size.
std::string object_notice(std::span<const std::string> names, Index object, MeshView mesh);

}  // namespace counterpart::io
