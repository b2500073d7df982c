// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Arrays cross the border by copies: JavaScript's are not in WebAssembly's memory, and a view into that ends
// when it grows.
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include <emscripten/val.h>

namespace counterpart::javascript {

using emscripten::val;

/// A typed array of JavaScript with a copy of the numbers.
template <class Number>
val array_of(const Number* numbers, std::size_t count) {
    return val(emscripten::typed_memory_view(count, numbers)).template call<val>("slice");
}
inline val array_of(const std::vector<Index>& numbers) { return array_of(numbers.data(), numbers.size()); }
inline val array_of(const std::vector<double>& numbers) { return array_of(numbers.data(), numbers.size()); }
inline val array_of(const Vector& numbers) {
    return array_of(numbers.data(), static_cast<std::size_t>(numbers.size()));
}
inline val array_of(const VertexMap& map) { return array_of(map.image()); }

/// The numbers of a typed array of JavaScript of the same kind.
template <class Number>
std::vector<Number> numbers_of(const val& array) {
    std::vector<Number> numbers(array["length"].as<std::size_t>());
    val(emscripten::typed_memory_view(numbers.size(), numbers.data())).template call<void>("set", array);
    return numbers;
}

/// What the library says, as objects.
inline val array_of(const std::vector<Message>& messages) {
    val array = val::array();
    for (const Message& message : messages) {
        val fields = val::object();
        fields.set("code", to_string(message.code));
        fields.set("severity", to_string(message.severity));
        fields.set("sentence", message.sentence);
        fields.set("subject", to_string(message.where.subject));
        fields.set("vertices", array_of(message.where.vertices));
        array.call<void>("push", fields);
    }
    return array;
}

/// An array of JavaScript of strings.
inline val array_of(const std::vector<std::string>& sentences) {
    val array = val::array();
    for (const std::string& sentence : sentences) array.call<void>("push", sentence);
    return array;
}

}  // namespace counterpart::javascript
