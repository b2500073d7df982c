// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/chosen_object.hpp"

#include "io/only_object.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::io {
namespace {

constexpr std::size_t most_listed = 10;

// As it can stand in a sentence: glTF allows any characters.
std::string described(std::span<const std::string> names, std::size_t object) {
    std::string name = names[object];
    for (char& c : name)
        if (static_cast<unsigned char>(c) < ' ') c = '_';
    return name.empty() ? fmt::format("{} (without a name)", object) : fmt::format("{} '{}'", object, name);
}

// "0 'arm', 1 'head'", or the first ten "and 3 more".
std::string listed(const std::vector<std::string>& all) {
    const std::span<const std::string> first(all.data(), std::min(all.size(), most_listed));
    const std::size_t more = all.size() - first.size();
    return fmt::format("{}{}", fmt::join(first, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

[[noreturn]] void refuse_unknown(std::span<const std::string> names, const std::string& wanted) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < names.size(); ++i)
        all.push_back(i < most_listed ? described(names, i) : std::string());
    throw InvalidInput(fmt::format(
        "there is no object '{}'; {}: {}", wanted,
        names.size() == 1 ? "the file has one object" : fmt::format("the file has {} objects", names.size()),
        listed(all)));
}

}  // namespace

Index chosen_object(std::span<const std::string> names, const std::string& wanted) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == wanted) numbers.push_back(std::to_string(i));
    if (numbers.size() > 1)
        throw InvalidInput(fmt::format("{} objects are named '{}': choose one by its number, of {}",
                                       numbers.size(), wanted, listed(numbers)));
    const std::string& digits = numbers.empty() ? wanted : numbers[0];
    std::size_t number = 0;
    const char* const end = digits.data() + digits.size();
    const auto [last, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc() || last != end || number >= names.size()) refuse_unknown(names, wanted);
    return static_cast<Index>(number);
}

void require_single_object(const std::string& wanted) { chosen_object(std::vector<std::string>(1), wanted); }

std::string object_notice(std::span<const std::string> names, Index object, MeshView mesh) {
    return fmt::format("object {} of {}: {} vertices, {} triangles",
                       described(names, static_cast<std::size_t>(object)), names.size(), mesh.n_vertices(),
                       mesh.n_triangles());
}

void take_object(AttributedMeshFile& file, const std::string& wanted) {
    const std::vector<std::string> names = file.content.objects.names;
    if (names.empty()) return require_single_object(wanted);
    const Index object = chosen_object(names, wanted);
    if (names.size() > 1) file.content = only_object(std::move(file.content), object);
    file.notices.push_back(object_notice(names, object, file.content.mesh));
}

}  // namespace counterpart::io
