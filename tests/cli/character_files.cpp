// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// character_files FOLDER: the generated character as GLB files, for the tests of the program.
//
//     character.glb  as an artist delivers it
//     again.glb      shuffled, exported anew, with vertices split in another way
//     copy.glb       the same as again.glb, but nothing beside the triangles, none of which share a vertex
#include "support/character_glb.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    using namespace counterpart;
    if (argc != 2) {
        std::fputs("usage: character_files FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        test::Character character = test::make_character({.subdivisions = 1});
        write_file(test::character_glb(character), folder / "character.glb");
        character.content = shuffle(character.content, 3).content;
        write_file(test::character_glb(character, {.shuffle_seed = 4, .every_corner_alone = true}),
                   folder / "again.glb");
        write_file(
            test::character_glb(character, {.shuffle_seed = 5, .every_corner_alone = true, .bare = true}),
            folder / "copy.glb");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
}
