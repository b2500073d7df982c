// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/match/verdict.hpp>

#include <algorithm>

namespace counterpart {

std::string to_string(Advice advice) {
    switch (advice) {
        case Advice::use:
            return "use";
        case Advice::check:
            return "check";
        case Advice::do_not_use:
            return "do not use";
    }
    return "unknown";
}

std::string reason(const Verdict& verdict) {
    std::string text;
    for (const Message& message : verdict.reasons) text += (text.empty() ? "" : "; ") + to_string(message);
    return text;
}

std::string to_string(const Verdict& verdict) {
    const std::string why = reason(verdict);
    return to_string(verdict.advice) + (why.empty() ? "" : ": " + why);
}

Verdict verdict(const std::vector<Message>& messages) {
    Verdict result;
    for (const Message& message : messages)
        if (message.severity != Severity::notice) result.reasons.push_back(message);
    std::stable_sort(result.reasons.begin(), result.reasons.end(),
                     [](const Message& a, const Message& b) { return a.severity > b.severity; });
    switch (gravest(messages)) {
        case Severity::notice:
            result.advice = Advice::use;
            break;
        case Severity::caution:
            result.advice = Advice::check;
            break;
        case Severity::do_not_use:
            result.advice = Advice::do_not_use;
            break;
    }
    return result;
}

Verdict verdict(const MatchResult& result) { return verdict(result.messages); }

}  // namespace counterpart
