// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/text_cursor.hpp"

#include <counterpart/base/errors.hpp>

#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

bool ends_line(char c) { return c == '\n' || c == '\r'; }
constexpr std::string_view blanks = " \t\v\f";
bool is_blank(char c) { return blanks.find(c) != blanks.npos; }
// A backslash at the line's end continues the line.
bool continues_line(const char* at, const char* end) {
    return *at == '\\' && at + 1 < end && ends_line(at[1]);
}
bool ends_word(const char* at, const char* end) {
    return at == end || is_blank(*at) || ends_line(*at) || *at == '#' || continues_line(at, end);
}

// from_chars knows no leading plus.
const char* skip_plus(const char* at, const char* end) {
    return end - at > 1 && *at == '+' && at[1] != '-' ? at + 1 : at;
}

// As older C libraries of Windows write what is no finite number, behind "1." or "-1.".
bool is_no_number_of_windows(std::string_view text) {
    return text.starts_with("#IND") || text.starts_with("#QNAN") || text.starts_with("#SNAN") ||
           text.starts_with("#INF");
}

}  // namespace

std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
    return word.size() > 24 ? text + "..." : text;
}

void TextCursor::skip_blanks() {
    while (at_ < end_) {
        if (is_blank(*at_)) {
            ++at_;
        } else if (continues_line(at_, end_)) {
            ++at_;
            next_line();
        } else {
            return;
        }
    }
}

bool TextCursor::at_line_end() {
    skip_blanks();
    return at_ == end_ || ends_line(*at_) || *at_ == '#';
}

void TextCursor::next_line() {
    while (at_ < end_ && !ends_line(*at_)) ++at_;
    if (at_ == end_) return;
    at_ += *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n' ? 2 : 1;
    ++line_;
}

void TextCursor::next_statement() {
    while (at_ < end_ && !ends_line(*at_) && *at_ != '#') {
        if (continues_line(at_, end_))
            next_line();
        else
            ++at_;
    }
    next_line();
}

bool TextCursor::next_content() {
    while (at_line_end() && at_ < end_) next_line();
    return at_ < end_;
}

std::string_view TextCursor::word() {
    if (at_line_end()) return {};
    const char* begin = at_;
    while (!ends_word(at_, end_)) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextCursor::rest() {
    const std::string_view line = rest_of_line();
    for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i] == '#' && is_blank(line[i - 1])) return stripped(line.substr(0, i), blanks);
    return line;
}

std::string_view TextCursor::rest_of_line() {
    skip_blanks();
    const char* last = at_;
    while (last < end_ && !ends_line(*last) && !continues_line(last, end_)) ++last;
    return stripped({at_, static_cast<std::size_t>(last - at_)}, blanks);
}

double TextCursor::number(std::string_view what) {
    if (at_line_end()) fail_at_word("a number", what);
    double value = 0;
    const char* begin = skip_plus(at_, end_);
    const auto [stop, error] = std::from_chars(begin, end_, value);
    if (error == std::errc::result_out_of_range) {
        // Too close to zero for a double is zero, too large is infinite.
        const std::string_view digits(begin, static_cast<std::size_t>(stop - begin));
        const std::size_t exponent = digits.find_first_of("eE"), whole = digits.find_first_not_of("-0");
        const bool tiny = exponent != digits.npos ? digits[exponent + 1] == '-' : digits[whole] == '.';
        value = tiny ? 0 : std::numeric_limits<double>::infinity();
    } else if (error != std::errc()) {
        fail_at_word("a number", what);
    }
    if (!ends_word(stop, end_)) fail_at_word("a number", what);
    at_ = stop;
    return is_no_number_of_windows({stop, remaining()}) ? skip_no_number() : value;
}

// 1.#QNAN0 and the like would be a number and a comment otherwise.
double TextCursor::skip_no_number() {
    ++at_;
    while (!ends_word(at_, end_)) ++at_;
    return std::numeric_limits<double>::quiet_NaN();
}

double TextCursor::coordinate(std::string_view what) {
    const double value = number(what);
    if (!std::isfinite(value)) fail(fmt::format("coordinate {} is not finite ({})", what, value));
    return value;
}

std::int64_t TextCursor::integer(std::string_view what, char delimiter) {
    if (at_line_end()) fail_at_word("a whole number", what);
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(skip_plus(at_, end_), end_, value);
    if (error == std::errc::result_out_of_range) fail(fmt::format("{} is out of range", what));
    if (error != std::errc() || (!ends_word(stop, end_) && *stop != delimiter))
        fail_at_word("a whole number", what);
    at_ = stop;
    return value;
}

std::string_view TextCursor::take(std::size_t size, std::string_view what) {
    if (size > remaining())
        fail(fmt::format("the file ends here: {} bytes of {} are missing", size - remaining(), what));
    at_ += size;
    return {at_ - size, size};
}

void TextCursor::fail_at_word(std::string_view expected, std::string_view what) {
    if (at_line_end()) {
        fail(fmt::format("expected {} ({}), but the {} ends here", expected, what,
                         at_ == end_ ? "file" : "line"));
    }
    fail(fmt::format("expected {} ({}), found '{}'", expected, what, shown(word())));
}

void TextCursor::fail_at(int line, std::string_view reason) const {
    throw IoError(fmt::format("{}:{}: {}", name_, line, reason));
}

}  // namespace counterpart::io
