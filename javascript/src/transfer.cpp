// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "content.hpp"
#include "guarded.hpp"

#include <counterpart/match/exact.hpp>
#include <counterpart/transfer/reorder.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <utility>

#include <emscripten/bind.h>
#include <fmt/format.h>

namespace counterpart::javascript {
namespace {

val reorder_content(const Content& source, const Content& target, bool allow_mirror, double weld_distance) {
    return guarded([&] {
        const ExactResult match = match_exact(source.mesh(), target.mesh(),
                                              {.allow_mirror = allow_mirror, .weld_distance = weld_distance});
        if (!match.identical)
            throw InvalidInput(
                fmt::format("the meshes have different connectivity ({}), so the order cannot be restored",
                            match.difference));
        std::vector<std::string> notices;
        for (const Message& message : match.messages) notices.push_back(to_string(message));
        AttributedMesh ordered = reorder(source.content, target.content, match.target_from_source,
                                         match.target_corner_from_source);
        if (match.mirrored) {
            ordered = turned_inside_out(std::move(ordered));
            notices.emplace_back(
                "its faces are wound the other way than the source's, so that the outside stays out");
        }
        return Content{std::move(ordered), std::move(notices)};
    });
}

val fields_of(const TransferredAttribute& attribute) {
    val fields = val::object();
    fields.set("name", attribute.name);
    fields.set("nTransferred", attribute.coverage.transferred);
    fields.set("nFilled", attribute.coverage.filled);
    fields.set("nGuessed", attribute.coverage.guessed);
    return fields;
}

val transfer_content(const Content& source, const Content& target, const val& map, const val& progress) {
    return guarded([&] {
        TransferResult result = transfer(source.content, target.content,
                                         VertexMap(numbers_of<Index>(map), target.mesh().n_vertices()),
                                         {.progress = progress_of(progress)});
        val attributes = val::array();
        for (const TransferredAttribute& attribute : result.attributes)
            attributes.call<void>("push", fields_of(attribute));
        val fields = val::object();
        fields.set("attributes", attributes);
        fields.set("messages", array_of(result.messages));
        fields.set("content", Content{std::move(result.content)});
        return fields;
    });
}

}  // namespace

EMSCRIPTEN_BINDINGS(transfer) {
    emscripten::function("reorder", &reorder_content);
    emscripten::function("transfer", &transfer_content);
}

}  // namespace counterpart::javascript
