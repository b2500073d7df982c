// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files.hpp"

#include <filesystem>

namespace counterpart::cli {

/// What can be read only once, standard input ('-') and other pipes, in files of their own that go with the
/// object: commands read some files twice, and the ending of a name tells the format. A pipe without an
/// ending gets the one that its bytes begin like.
class KeptStreams {
  public:
    /// Puts the kept files in the place of those that are read. Throws InvalidInput if '-' is given twice or
    /// is no mesh, IoError if a pipe cannot be read, WriteError if there is no room for it.
    explicit KeptStreams(const FileArguments& files);

  private:
    // Goes with the object, also where its files cannot all be kept.
    struct Folder {
        Folder() = default;
        Folder(const Folder&) = delete;
        Folder& operator=(const Folder&) = delete;
        ~Folder();
        std::filesystem::path path{};
    };
    void keep(const FileArgument& argument, std::filesystem::path& file);

    Folder folder_{};
    int n_kept_ = 0;
};

}  // namespace counterpart::cli
