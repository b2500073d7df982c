// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/message.hpp>

#include <set>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Message, ItsSentenceNamesTheMeshThatItIsAbout) {
    Message message{MessageCode::fragments, Severity::do_not_use, "mostly fragments"};
    EXPECT_EQ(to_string(message), "mostly fragments");
    message.where.subject = Subject::target;
    EXPECT_EQ(to_string(message), "target: mostly fragments");
    message.where.subject = Subject::source;
    EXPECT_EQ(to_string(message), "source: mostly fragments");
}

TEST(Message, EachCodeHasAName) {
    std::set<std::string> names;
    for (int code = 0; code <= static_cast<int>(MessageCode::turned_inside_out); ++code)
        names.insert(to_string(static_cast<MessageCode>(code)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(MessageCode::turned_inside_out) + 1);
    EXPECT_FALSE(names.contains("unknown"));
}

TEST(Message, TheGravestIsFoundWhereverItIs) {
    const Message notice{MessageCode::flat, Severity::notice, ""},
        caution{MessageCode::unsure, Severity::caution, ""},
        grave{MessageCode::poor_score, Severity::do_not_use, ""};
    EXPECT_EQ(gravest({}), Severity::notice);
    EXPECT_EQ(gravest({notice, caution, notice}), Severity::caution);
    EXPECT_EQ(gravest({caution, notice, grave}), Severity::do_not_use);
    EXPECT_TRUE(contains({notice, grave}, MessageCode::poor_score));
    EXPECT_FALSE(contains({notice, grave}, MessageCode::unsure));
}

}  // namespace
}  // namespace counterpart
