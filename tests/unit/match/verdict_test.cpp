// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/messages.hpp"
#include "support/quick_match.hpp"

#include <counterpart/match/match.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::lines_of;

const Message on_input{
    MessageCode::merged_vertices, Severity::notice, "merged 1 duplicate vertex", {Subject::source}};
const Message on_components{MessageCode::components_differ, Severity::caution, "the source has 2 components"};
const Message on_score{MessageCode::poor_score, Severity::do_not_use, "no map fits"};

// A pair that also differs in components must not lose what is worse.
TEST(Verdict, AllMessagesCountInAnyOrder) {
    for (const std::vector<Message>& messages : {std::vector{on_input, on_components, on_score},
                                                 {on_score, on_components, on_input},
                                                 {on_components, on_score, on_input}}) {
        const Verdict found = verdict(messages);
        EXPECT_EQ(found.advice, Advice::do_not_use);
        ASSERT_EQ(found.reasons.size(), 2U);
        EXPECT_EQ(found.reasons[0].code, MessageCode::poor_score);
        EXPECT_EQ(to_string(found), "do not use: no map fits; the source has 2 components");
    }
    EXPECT_EQ(verdict({on_input, on_components}).advice, Advice::check);
    EXPECT_EQ(to_string(verdict({on_input})), "use");
    EXPECT_EQ(to_string(verdict(std::vector<Message>{})), "use");
}

TEST(Verdict, FragmentsAreNotToBeUsed) {
    TriangleMesh dust{Points(360, 3), Triangles(120, 3)};
    for (Index t = 0; t < 120; ++t) {
        for (int c = 0; c < 3; ++c) {
            dust.vertices.row(3 * t + c) << t + (c == 1), t * t % 7 + (c == 2), t % 3;
            dust.triangles(t, c) = 3 * t + c;
        }
    }
    const MatchResult result =
        match(dust, make_body({.subdivisions = 0}), test::quick(MatchMethod::spectral));
    EXPECT_TRUE(contains(result.messages, MessageCode::fragments)) << lines_of(result.messages);
    EXPECT_EQ(verdict(result).advice, Advice::do_not_use);
}

const TriangleMesh doubted = make_grid(9, 9);  // 100 vertices

VertexMap to_itself() { return identity_map(doubted.n_vertices()); }

TEST(Doubts, FollowTheShareOfVerticesOfLittleConfidence) {
    struct Case {
        Index n_doubtful;
        Severity severity;
    };
    for (const Case& expected : {Case{4, Severity::notice},
                                 {9, Severity::notice},
                                 {11, Severity::caution},
                                 {49, Severity::caution},
                                 {51, Severity::do_not_use},
                                 {100, Severity::do_not_use}}) {
        Vector confidence = Vector::Ones(doubted.n_vertices());
        confidence.head(expected.n_doubtful).setConstant(0.1);
        const std::vector<Message> found = doubts(to_itself(), confidence, doubted);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].code, MessageCode::doubtful_vertices);
        EXPECT_EQ(found[0].severity, expected.severity) << expected.n_doubtful;
        EXPECT_EQ(found[0].where.vertices.size(), static_cast<std::size_t>(expected.n_doubtful));
    }
    EXPECT_TRUE(doubts(to_itself(), Vector::Constant(100, 0.3), doubted).empty());
}

TEST(Doubts, TellThePlaceOfTheLargestRegion) {
    Vector confidence = Vector::Ones(doubted.n_vertices());
    const Index corner = doubted.n_vertices() - 1;
    confidence[0] = 0.1;  // alone
    for (const Index v : {corner, corner - 1, corner - 10, corner - 11, corner - 2, corner - 12})
        confidence[v] = 0.1;
    const std::vector<Message> found = doubts(to_itself(), confidence, doubted);
    ASSERT_EQ(found.size(), 1U);
    const std::vector<Index>& where = found[0].where.vertices;
    EXPECT_EQ(where.size(), 7U);
    const Eigen::RowVector3d middle =
        (doubted.vertices.row(corner - 1) + doubted.vertices.row(corner - 11)) / 2;  // of the six
    EXPECT_NE(found[0].sentence.find(std::to_string(middle[0]).substr(0, 4)), std::string::npos)
        << found[0].sentence;
}

TEST(Doubts, VerticesWithoutAPartnerAreAsTheyShouldBeWhereTheTargetIsAPart) {
    std::vector<Index> image(100, VertexMap::unmatched);
    for (Index v = 0; v < 30; ++v) image[static_cast<std::size_t>(v)] = v;
    const Vector sure = Vector::Ones(100);
    const std::vector<Message> of_part = doubts(VertexMap(image, 31), sure, doubted),
                               of_whole = doubts(VertexMap(image, 100), sure, doubted);
    ASSERT_EQ(of_part.size(), 1U);
    EXPECT_EQ(of_part[0].code, MessageCode::few_partners);
    EXPECT_EQ(of_part[0].severity, Severity::notice);
    ASSERT_EQ(of_whole.size(), 1U);
    EXPECT_EQ(of_whole[0].severity, Severity::caution);
    const VertexMap nothing(std::vector<Index>(100, VertexMap::unmatched), 100);
    EXPECT_EQ(gravest(doubts(nothing, sure, doubted)), Severity::do_not_use);
}

TEST(Doubts, OfAMethodWithoutConfidenceTheMapIsToBeLookedAt) {
    for (const Vector& none : {Vector(), Vector(Vector::Zero(100))}) {
        const std::vector<Message> found = doubts(to_itself(), none, doubted);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].code, MessageCode::no_confidence);
        EXPECT_EQ(found[0].severity, Severity::caution);
    }
}

TEST(ProbableCauses, AreUnlikeShapesOnlyWhereNothingFits) {
    const TriangleMesh body = make_body({.subdivisions = 0});
    EXPECT_TRUE(probable_causes(body, body, {on_input}).empty());
    EXPECT_FALSE(contains(probable_causes(body, body, {on_components}), MessageCode::unlike_shapes));
    EXPECT_TRUE(contains(probable_causes(body, body, {on_score}), MessageCode::unlike_shapes));
    const Message rival{MessageCode::close_runner_up, Severity::caution, ""};
    const std::vector<Message> of_rival = probable_causes(body, body, {rival});
    EXPECT_TRUE(contains(of_rival, MessageCode::self_similar));
    EXPECT_FALSE(contains(of_rival, MessageCode::unlike_shapes));
}

// Vertices at one place are merged by the methods that this is about: welding them would change nothing.
TEST(ProbableCauses, DoNotAdviseToWeldWhatIsMergedAnyway) {
    const TriangleMesh body = make_body({.subdivisions = 0});
    TriangleMesh doubled = body;
    doubled.vertices.row(1) = doubled.vertices.row(0);
    EXPECT_FALSE(contains(probable_causes(doubled, body, {on_score}), MessageCode::weldable));
}

TEST(ProbableCauses, MissingPartsComeFirst) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    TriangleMesh open = body;
    open.triangles.conservativeResize(open.n_triangles() * 3 / 4, Eigen::NoChange);
    open.vertices *= 1000;
    const std::vector<Message> causes = probable_causes(body, open, {on_score});
    ASSERT_GE(causes.size(), 3U) << lines_of(causes);
    EXPECT_EQ(causes[0].code, MessageCode::openness_differs);
    EXPECT_EQ(causes[0].where.subject, Subject::target);
    EXPECT_TRUE(contains(causes, MessageCode::scale_differs));
}

}  // namespace
}  // namespace counterpart
