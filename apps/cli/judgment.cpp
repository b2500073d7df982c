// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "judgment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

std::string joined(const std::vector<Message>& messages, const MeshPair& pair) {
    std::vector<std::string> sentences;
    for (const Message& message : messages) sentences.push_back(named(message, pair));
    return fmt::format("{}", fmt::join(sentences, "; "));
}

}  // namespace

Json to_json(const std::vector<Message>& messages) {
    Json list = Json::array();
    for (const Message& message : messages)
        list.push_back(
            {{"code", to_string(message.code)},
             {"severity", to_string(message.severity)},
             {"sentence", message.sentence},
             {"where",
              {{"subject", to_string(message.where.subject)}, {"vertices", message.where.vertices}}}});
    return list;
}

Json Judgment::report() const {
    const Verdict found = verdict();
    return {{"verdict", to_string(found.advice)},
            {"verdict_reason", reason(found)},
            {"probable_causes", to_json(causes)}};
}

std::string named(const Message& message, const MeshPair& pair) {
    switch (message.where.subject) {
        case Subject::source:
            return pair.source_file.words() + ": " + message.sentence;
        case Subject::target:
            return pair.target_file.words() + ": " + message.sentence;
        case Subject::map:
            break;
    }
    return message.sentence;
}

void say_verdict(const CommonOptions& options, const Judgment& judgment, const MeshPair& pair) {
    const Verdict verdict = judgment.verdict();
    const std::string reasons = joined(verdict.reasons, pair);
    say(options, to_string(verdict.advice) + (reasons.empty() ? "" : ": " + reasons));
    if (!judgment.causes.empty())
        say(options, "probable causes, the likeliest first: " + joined(judgment.causes, pair));
}

void say_messages(const CommonOptions& options, const std::vector<Message>& messages, const MeshPair& pair) {
    for (const Message& message : messages) {
        if (message.severity == Severity::notice)
            say(options, named(message, pair));
        else if (message.where.subject == Subject::map)
            warn(fmt::format("{} -> {}: {}", pair.source_file.words(), pair.target_file.words(),
                             message.sentence));
        else
            warn(named(message, pair));
    }
}

}  // namespace counterpart::cli
