// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/isomorphism/component_classes.hpp"

#include <initializer_list>
#include <string>

namespace counterpart::isomorphism {

struct Property {
    const char* name;  ///< in the plural
    std::size_t in_source, in_target;
};

/// The first property that the two have in different numbers, as a sentence; empty if none differs.
std::string first_difference(std::initializer_list<Property> properties);

/// What two maps differ in at a glance; empty if nothing.
std::string first_difference(const DartMap& source, const DartMap& target);

/// The first class of components that one mesh has more of; empty if both have as many of each.
std::string first_difference(const DartMap& source, const DartMap& target,
                             const std::vector<ComponentClass>& classes);

}  // namespace counterpart::isomorphism
