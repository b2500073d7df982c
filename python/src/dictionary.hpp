// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "arrays.hpp"

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/mesh/analyze.hpp>

#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace counterpart::python {

namespace nb = nanobind;

inline void add_items(nb::dict&) {}
template <class Value, class... Rest>
void add_items(nb::dict& dictionary, const char* name, Value&& value, Rest&&... rest) {
    dictionary[name] = std::forward<Value>(value);
    add_items(dictionary, std::forward<Rest>(rest)...);
}

/// {name: value, ...} of names and values in turn.
template <class... Items>
nb::dict dictionary_of(Items&&... items) {
    nb::dict dictionary;
    add_items(dictionary, std::forward<Items>(items)...);
    return dictionary;
}

/// {stage: seconds}
inline nb::dict seconds_of(const std::vector<StageTime>& stages) {
    nb::dict seconds;
    for (const StageTime& stage : stages) seconds[stage.stage.c_str()] = stage.seconds;
    return seconds;
}

inline nb::list list_of(const std::vector<Message>& messages) {
    nb::list list;
    for (const Message& message : messages)
        list.append(dictionary_of("code", to_string(message.code), "severity", to_string(message.severity),
                                  "sentence", message.sentence, "subject", to_string(message.where.subject),
                                  "vertices", array(message.where.vertices)));
    return list;
}

/// Of meshes.cpp.
nb::dict counts_of(const MeshReport& report);

inline nb::dict counts_of(const Coverage& coverage) {
    return dictionary_of("transferred", coverage.transferred, "filled", coverage.filled, "guessed",
                         coverage.guessed);
}

}  // namespace counterpart::python
