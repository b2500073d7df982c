// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What the value of an option may be, refused with a sentence.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace counterpart::cli {

/// One of these words.
CLI::Validator one_of(const std::vector<std::string>& words);

/// A whole number from `least` to `most`.
CLI::Validator whole_number(long long least, long long most);
/// A whole number of at least `least`.
CLI::Validator whole_number(long long least);

/// A number from `least` to `most`.
CLI::Validator number(double least, double most);
/// A number of at least 0; above 0.
CLI::Validator non_negative();
CLI::Validator positive();

/// The words nearest to one that was mistyped, nearest first, at most three; none if none is near.
std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& words);
/// ". Did you mean 'a' or 'b'?", or nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& words);

}  // namespace counterpart::cli
