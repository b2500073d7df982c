// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace counterpart::io {

/// The text behind the byte order mark that some programs begin UTF-8 with.
inline std::string_view without_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

/// The text without these characters at either end.
inline std::string_view stripped(std::string_view text, std::string_view of = " \t\r") {
    const std::size_t first = text.find_first_not_of(of);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(of) - first + 1);
}

/// For messages: a long or binary word is cut and made printable.
std::string shown(std::string_view word);

/// Walks through a text file held in memory, line by line and word by word, and knows the line it is on.
/// A byte order mark before the text is passed over. Lines end with LF, CR LF or CR; a backslash at a line's
/// end continues the line; '#' starts a comment.
class TextCursor {
  public:
    /// `name` leads the error messages; `first_line` is the number of the text's first line.
    TextCursor(std::string_view text, std::string name, int first_line = 1)
        : at_(text.data()), end_(text.data() + text.size()), name_(std::move(name)), line_(first_line) {
        at_ += text.size() - without_mark(text).size();
    }

    /// Moves to the next word, over blank lines and comments; false at the end of the file.
    bool next_content();
    /// True if the line has no further word.
    bool at_line_end();
    /// Moves behind the end of the line.
    void next_line();
    /// The same for a line and those that continue it.
    void next_statement();

    /// The next word of the line; empty at the line's end.
    std::string_view word();
    /// All that follows on the line, blanks inside included, as names have them: a comment must have a blank
    /// before it. Stays where it is, since for all else a comment begins, and a line ends, at any '#'.
    std::string_view rest();
    /// The same with what looks like a comment, as names of files have it.
    std::string_view rest_of_line();
    /// Gives the last `count` characters of the word just read back.
    void put_back(std::size_t count) { at_ -= count; }
    /// The next character, 0 at the end of the file.
    char peek() const { return at_ < end_ ? *at_ : '\0'; }

    /// The next word of the line as a number (NaN and infinity pass). `what` names it in errors.
    double number(std::string_view what);
    /// The next whole number of the line; it must be followed by a blank, the line's end or `delimiter`.
    std::int64_t integer(std::string_view what, char delimiter = ' ');
    /// x, y or z of a point: a number that is finite.
    double coordinate(std::string_view what);

    /// The next `size` bytes, whatever they are: numbers in binary between lines. Fails if there are fewer.
    std::string_view take(std::size_t size, std::string_view what);

    int line() const { return line_; }
    std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
    /// Throws IoError "name:line: reason".
    [[noreturn]] void fail(std::string_view reason) const { fail_at(line_, reason); }
    [[noreturn]] void fail_at(int line, std::string_view reason) const;

  private:
    void skip_blanks();
    double skip_no_number();
    [[noreturn]] void fail_at_word(std::string_view expected, std::string_view what);

    const char* at_;
    const char* end_;
    std::string name_;
    int line_;
};

}  // namespace counterpart::io
