// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "checks.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

template <class Number>
std::optional<Number> parsed(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || rest != end) return std::nullopt;
    return number;
}

CLI::Validator real_number(const std::function<bool(double)>& fits, const std::string& wanted,
                           const std::string& shown) {
    return {[fits, wanted](std::string& text) {
                const std::optional<double> value = parsed<double>(text);
                if (value && std::isfinite(*value) && fits(*value)) return std::string();
                return fmt::format("must be {}, not '{}'", wanted, text);
            },
            shown};
}

// Insertions, deletions, exchanged letters and swapped neighbors (Damerau 1964).
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

CLI::Validator one_of(const std::vector<std::string>& words) {
    return {[words](std::string& text) {
                if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
                return fmt::format("must be one of {}, not '{}'{}", fmt::join(words, ", "), text,
                                   suggestion(text, words));
            },
            fmt::format("{{{}}}", fmt::join(words, ","))};
}

CLI::Validator whole_number(long long least, long long most) {
    const bool open = most == std::numeric_limits<long long>::max();
    const std::string range =
        open ? fmt::format("of at least {}", least) : fmt::format("from {} to {}", least, most);
    return {[least, most, range](std::string& text) {
                const std::optional<long long> value = parsed<long long>(text);
                if (value && *value >= least && *value <= most) return std::string();
                return fmt::format("must be a whole number {}, not '{}'", range, text);
            },
            range};
}

CLI::Validator whole_number(long long least) {
    return whole_number(least, std::numeric_limits<long long>::max());
}

CLI::Validator number(double least, double most) {
    return real_number([=](double value) { return value >= least && value <= most; },
                       fmt::format("a number from {} to {}", least, most),
                       fmt::format("from {} to {}", least, most));
}

CLI::Validator non_negative() {
    return real_number([](double value) { return value >= 0; }, "a number of at least 0", "at least 0");
}

CLI::Validator positive() {
    return real_number([](double value) { return value > 0; }, "a number above 0", "above 0");
}

std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& words) {
    constexpr std::size_t most_listed = 3;
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const std::string& other : words) {
        const bool contains = word.size() > 2 && other.find(word) != std::string::npos;
        const std::size_t distance = contains ? 1 : edit_distance(word, other);
        if (distance <= std::max<std::size_t>(2, word.size() / 3) && distance < other.size())
            ranked.emplace_back(distance, other);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> nearest;
    for (std::size_t i = 0; i < std::min(most_listed, ranked.size()); ++i)
        nearest.push_back(ranked[i].second);
    return nearest;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& words) {
    std::vector<std::string> nearest;
    for (const std::string& other : nearest_words(word, words)) nearest.push_back("'" + other + "'");
    return nearest.empty() ? "" : fmt::format(". Did you mean {}?", fmt::join(nearest, " or "));
}

}  // namespace counterpart::cli
