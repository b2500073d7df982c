// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

namespace fs = std::filesystem;

// The endings of each content; nothing: any that belongs to no other content.
struct Endings {
    const char* what;
    std::vector<std::string> fitting;
};

std::vector<std::string> written_meshes() {
    const MeshExtensions extensions = mesh_extensions();
    std::vector<std::string> all = extensions.written;
    for (const std::string& solid : extensions.written_solids)
        if (std::find(all.begin(), all.end(), solid) == all.end()) all.push_back(solid);
    return all;
}

const Endings& endings_of(Content content) {
    static const std::map<Content, Endings> endings = {
        {Content::mesh, {"a mesh", written_meshes()}},
        {Content::matrix, {"a matrix", {".npy"}}},
        {Content::page, {"a web page", {".html", ".htm"}}},
        {Content::picture, {"a picture", {".png", ".svg"}}},
        {Content::map, {"a map", {}}},
        {Content::landmarks, {"landmarks", {".json", ".fcsv", ".csv", ".tps"}}},
        {Content::table, {"a table", {}}},
        {Content::report, {"a report", {}}},
        {Content::frames, {"the frames", {}}},
        {Content::prefix, {"maps", {}}},
        {Content::folder, {"files", {}}}};
    return endings.at(content);
}

// Of its own, which is made if it is not there.
bool fills_folder(Content content) { return content == Content::frames || content == Content::folder; }

// Endings that promise something else to whoever opens the file.
std::string other_content(const fs::path& file, Content content) {
    const std::string ending = lower_extension(file);
    const auto is_one_of = [&](const std::vector<std::string>& endings) {
        return std::find(endings.begin(), endings.end(), ending) != endings.end();
    };
    for (const Content other : {Content::mesh, Content::page, Content::picture})
        if (is_one_of(endings_of(other).fitting)) return endings_of(other).what;
    if (ending == ".npy" && content != Content::map) return "a matrix";
    if (is_one_of({".npz", ".mat", ".zip", ".gz"})) return "an archive";
    if (is_one_of({".jpg", ".jpeg", ".exr", ".tga"})) return "a picture";
    if (is_one_of({".fbx", ".usd", ".dae", ".abc", ".blend"})) return "a scene";
    return "";
}

void require_fitting_ending(const FileArgument& argument, const fs::path& file) {
    const Endings& endings = endings_of(*argument.written);
    if (!endings.fitting.empty()) {
        const std::string ending = lower_extension(file);
        if (std::find(endings.fitting.begin(), endings.fitting.end(), ending) != endings.fitting.end())
            return;
        throw InvalidInput(fmt::format("{} {}: the name of {} must end in {}", argument.option,
                                       utf8_name(file), endings.what, fmt::join(endings.fitting, ", ")));
    }
    if (fills_folder(*argument.written) || *argument.written == Content::prefix) return;
    if (const std::string other = other_content(file, *argument.written); !other.empty())
        throw InvalidInput(fmt::format("{} {}: this is to be {}, but the ending is that of {}",
                                       argument.option, utf8_name(file), endings.what, other));
}

// Files of programs that hold more than a mesh, which the Python package reads through one of them.
bool is_scene(const fs::path& file) {
    constexpr std::array<std::string_view, 7> scenes = {".fbx",  ".usd", ".usda", ".usdc",
                                                        ".usdz", ".abc", ".blend"};
    return std::find(scenes.begin(), scenes.end(), lower_extension(file)) != scenes.end();
}

void refuse_scenes(const FileArguments& files) {
    for (const FileArgument& argument : files) {
        if (argument.written) continue;
        for (const fs::path* file : argument.names()) {
            if (!is_scene(*file)) continue;
            std::error_code ignored;
            if (!fs::exists(*file, ignored))
                throw InvalidInput(
                    fmt::format("{} {}: there is no such file", argument.option, utf8_name(*file)));
            throw InvalidInput(
                fmt::format("{} {}: this is a scene; 'counterpart import {} {}' makes a mesh file of it, "
                            "through Blender",
                            argument.option, utf8_name(*file), utf8_name(*file),
                            utf8_name(fs::path(*file).replace_extension(".glb"))));
        }
    }
}

bool is_regular_or_new(const fs::path& file) {
    if (platform::is_nameless_output(file)) return false;
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    return !fs::exists(status) || fs::is_regular_file(status);
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    const fs::path one = fs::weakly_canonical(fs::absolute(a), error);
    if (error) return false;  // a pipe
    return one == fs::weakly_canonical(fs::absolute(b), error) && !error;
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void require_writable(const FileArgument& argument, const fs::path& file) {
    const auto refuse = [&](const std::string& reason) {
        throw WriteError(fmt::format("{} {}: {}", argument.option, utf8_name(file), reason));
    };
    if (platform::is_nameless_output(file)) return;
    std::error_code ignored;
    const fs::file_status state = fs::status(file, ignored);
    const bool exists = fs::exists(state), is_folder = fs::is_directory(state);
    if (is_folder && !fills_folder(*argument.written)) {
        if (*argument.written == Content::prefix) return;
        refuse("is a folder; name a file in it");
    }
    if (exists && !is_folder && *argument.written == Content::folder) refuse("is not a folder");
    constexpr fs::perms any_write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if (fs::is_regular_file(state) && (state.permissions() & any_write) == fs::perms::none)
        refuse("is read-only");  // also to root, who could replace it
    if (const int error = platform::error_of_writing(file); exists && error != 0)
        refuse(fmt::format("cannot be written ({})", std::strerror(error)));
    if (exists && !fs::is_regular_file(state) && !is_folder) return;
    fs::path folder = is_folder ? file : folder_of(file);
    if (fills_folder(*argument.written))
        while (!fs::exists(folder, ignored) && folder != folder_of(folder)) folder = folder_of(folder);
    if (!fs::exists(folder, ignored))
        refuse(fmt::format("there is no folder {}; create it first", utf8_name(folder)));
    if (!fs::is_directory(folder, ignored)) refuse(fmt::format("{} is not a folder", utf8_name(folder)));
    // A file that is there is replaced by one made beside it, or beside what it links to.
    if (exists && !is_folder) folder = folder_of(fs::canonical(file, ignored));
    if (const int error = platform::error_of_making_files(folder); error != 0)
        refuse(fmt::format("the folder cannot be written ({})", std::strerror(error)));
}

void require_distinct(const FileArguments& files, std::size_t written, const fs::path& output) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool is_earlier_output = files[i].written && i < written;
        if (files[i].written && !is_earlier_output) continue;
        for (const fs::path* other : files[i].names()) {
            if (other->empty() || !is_same_file(*other, output)) continue;
            if (!files[i].written)
                throw InvalidInput(fmt::format("{} {} would replace {}, which is read; write to another file",
                                               files[written].option, utf8_name(output), files[i].option));
            throw InvalidInput(fmt::format("{} and {} both name {}; give each a file of its own",
                                           files[i].option, files[written].option, utf8_name(output)));
        }
    }
}

std::string name_of(const std::string& names) {  // the last: "-o,--output" is --output
    return names.substr(names.rfind(',') + 1);
}

}  // namespace

CLI::Option* add_path(CLI::App& command, const std::string& name, fs::path& path, const std::string& help) {
    const auto set = [&path](const std::string& word) { path = platform::path_of(word); };
    return command.add_option_function<std::string>(name, set, help);
}

std::vector<fs::path*> FileArgument::names() const {
    if (file != nullptr) return {file};
    std::vector<fs::path*> all;
    for (fs::path& one : *several) all.push_back(&one);
    return all;
}

CLI::Option* add_input(CLI::App& command, FileArguments& files, const std::string& name, fs::path& file,
                       const std::string& help) {
    files.push_back({name_of(name), &file, nullptr, {}});
    CLI::Option* option = add_path(command, name, file, help);
    return name[0] == '-' ? option->type_name("FILE") : option;
}

CLI::Option* add_input(CLI::App& command, FileArguments& files, const std::string& name,
                       std::vector<fs::path>& several, const std::string& help) {
    files.push_back({name_of(name), nullptr, &several, {}});
    const auto set = [&several](const std::vector<std::string>& words) {
        several.clear();
        for (const std::string& word : words) several.push_back(platform::path_of(word));
    };
    CLI::Option* option = command.add_option_function<std::vector<std::string>>(name, set, help);
    return name[0] == '-' ? option->type_name("FILE") : option;
}

std::string MeshInput::words() const {
    return object ? fmt::format("{}, object '{}'", utf8_name(file), *object) : utf8_name(file);
}

CLI::Option* add_mesh(CLI::App& command, FileArguments& files, const std::string& name,
                      const std::string& object, MeshInput& mesh, const std::string& help) {
    files.push_back({name_of(name), &mesh.file, nullptr, {}, &mesh, object});
    CLI::Option* option = add_path(command, name, mesh.file, help);
    command
        .add_option_function<std::string>(
            object, [&mesh](const std::string& chosen) { mesh.object = chosen; },
            fmt::format("Read this object of {} alone: its name, or its number as 'inspect' lists it", name))
        ->type_name("OBJECT");
    return option;
}

CLI::Option* add_output(CLI::App& command, FileArguments& files, const std::string& name, fs::path& file,
                        Content content, const std::string& help) {
    files.push_back({name_of(name), &file, nullptr, content});
    return add_path(command, name, file, help)->type_name("FILE");
}

void check_files(const FileArguments& files) {
    for (const FileArgument& argument : files)
        if (argument.mesh != nullptr && argument.mesh->object && argument.file->empty())
            throw InvalidInput(fmt::format("{} needs {}", argument.object_option, argument.option));
    refuse_scenes(files);
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!files[i].written || files[i].file->empty()) continue;
        fs::path& output = *files[i].file;
        if (output == "-") output = platform::standard_output;
        const bool is_stream = !is_regular_or_new(output) && !fs::is_directory(output);
        // A stream without an ending takes what is written as text.
        if (!is_stream || output.has_extension()) require_fitting_ending(files[i], output);
        require_writable(files[i], output);
        if (!is_stream || output == platform::standard_output) require_distinct(files, i, output);
    }
}

void print(const std::string& text) {
    const bool whole =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!whole && errno == EPIPE) throw ClosedPipe("standard output: nobody reads it any more");
    if (!whole)
        throw WriteError(fmt::format("standard output: could not be written ({})", std::strerror(errno)));
}

}  // namespace counterpart::cli
