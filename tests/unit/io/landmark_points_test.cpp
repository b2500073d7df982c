// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/landmark_points.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

class LandmarkPointFiles : public testing::Test {
  protected:
    LandmarkPoints read(const std::string& name, const std::string& text,
                        std::optional<Anatomical> axes = {}) const {
        write_file(text, folder_ / name);
        return read_landmark_points(folder_ / name, axes);
    }
    void refused(const std::string& name, const std::string& text, const std::string& part) const {
        test::expect_error<IoError>([&] { read(name, text); }, part);
    }
    test::TemporaryFolder folder_;
};

const std::string slicer =
    R"({"@schema":"x","markups":[{"type":"Fiducial","coordinateSystem":"LPS","controlPoints":[
{"id":"1","label":"nose","position":[1,2,3],"positionStatus":"defined"},
{"id":"2","label":"gone","position":[0,0,0],"positionStatus":"undefined"},
{"id":"3","label":"","position":[-4,5e-1,6]}]}]})";
const std::string fcsv =
    "# Markups fiducial file version = 4.10\n# CoordinateSystem = 0\n# columns = id,x,y,z\n"
    "vtk_1,-1,-2,3,0,0,0,1,1,1,0,nose,,vtk\nvtk_2,4,-0.5,6,0,0,0,1,1,1,0,,,\n";

TEST_F(LandmarkPointFiles, OfSlicerInEitherFrame) {
    const LandmarkPoints lps = read("a.mrk.json", slicer), ras = read("a.fcsv", fcsv);
    ASSERT_EQ(lps.landmarks.size(), 2U);
    EXPECT_EQ(lps.axes, Anatomical::lps);
    EXPECT_EQ(lps.landmarks[0].name, "nose");
    EXPECT_EQ(lps.landmarks[1].name, "3");
    EXPECT_EQ(lps.landmarks[1].point, Eigen::RowVector3d(-4, 0.5, 6));
    ASSERT_EQ(ras.landmarks.size(), 2U);
    EXPECT_EQ(ras.axes, Anatomical::ras);
    EXPECT_EQ(ras.landmarks[0].name, "nose");
    EXPECT_EQ(ras.landmarks[0].point, Eigen::RowVector3d(-1, -2, 3));
    // The same points, once one of the files is turned.
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(read("a.fcsv", fcsv, Anatomical::lps).landmarks[i].point, lps.landmarks[i].point);
    EXPECT_EQ(read("a.mrk.json", slicer, Anatomical::lps).landmarks[0].point, lps.landmarks[0].point);
}

TEST_F(LandmarkPointFiles, OfScalismoAndTables) {
    const std::string json = R"([{"id":"nose","coordinates":[1,2,3]},{"id":"ear","coordinates":[4,5,6]}])";
    for (const auto& file :
         {std::pair("a.json", json),
          std::pair("a.csv", std::string("\xef\xbb\xbfname,x,y,z\r\nnose,1,2,3\r\n\r\n\"ear\", 4,5,6\r\n")),
          std::pair("b.csv", std::string("nose;1;2;3\near;4;5;6"))}) {
        const std::string name = file.first, text = file.second;
        const LandmarkPoints points = read(name, text);
        ASSERT_EQ(points.landmarks.size(), 2U) << name;
        EXPECT_EQ(points.landmarks[1].name, "ear") << name;
        EXPECT_EQ(points.landmarks[1].point, Eigen::RowVector3d(4, 5, 6)) << name;
        EXPECT_FALSE(points.axes) << name;
        test::expect_error<IoError>([&] { read(name, text, Anatomical::ras); },
                                    "does not say whether its points are LPS or RAS");
    }
}

TEST_F(LandmarkPointFiles, WhatIsWrittenIsReadAgain) {
    LandmarkPoints points = read("a.mrk.json", slicer);
    for (const char* name : {"b.mrk.json", "b.fcsv", "b.json", "b.csv"}) {
        write_landmark_points(points, folder_ / name);
        const LandmarkPoints again = read_landmark_points(folder_ / name);
        ASSERT_EQ(again.landmarks.size(), 2U) << name;
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(again.landmarks[i].name, points.landmarks[i].name) << name;
            EXPECT_EQ(again.landmarks[i].point, points.landmarks[i].point) << name;
        }
    }
    EXPECT_EQ(read_landmark_points(folder_ / "b.fcsv").axes, Anatomical::lps);
    write_landmark_points(points, folder_ / "b.tps");
    EXPECT_EQ(read_whole_file(folder_ / "b.tps"), "LM3=2\n1 2 3\n-4 0.5 6\n");
    points.axes.reset();
    for (const char* name : {"c.mrk.json", "c.fcsv"})
        test::expect_error<IoError>([&] { write_landmark_points(points, folder_ / name); },
                                    "says LPS or RAS, and which it is was not given");
    points.landmarks[0].name = "left, upper";
    test::expect_error<IoError>([&] { write_landmark_points(points, folder_ / "c.csv"); },
                                "characters that the format cannot hold");
}

TEST_F(LandmarkPointFiles, ArePairedByName) {
    const TriangleMesh mesh = make_icosphere(1);
    LandmarkPoints a, b;
    a.landmarks = {
        {"one", mesh.vertices.row(3)}, {"only here", mesh.vertices.row(5)}, {"two", mesh.vertices.row(7)}};
    b.landmarks = {{"two", mesh.vertices.row(9)}, {"one", mesh.vertices.row(11)}};
    EXPECT_EQ(landmark_pairs(a, mesh, b, mesh), (std::vector<std::pair<Index, Index>>{{3, 11}, {7, 9}}));
    b.landmarks[0].name = "one";
    test::expect_error<InvalidInput>([&] { landmark_pairs(a, mesh, b, mesh); },
                                     "the target has two landmarks 'one'");
    b.landmarks = {{"other", mesh.vertices.row(0)}};
    test::expect_error<InvalidInput>([&] { landmark_pairs(a, mesh, b, mesh); }, "no landmark of the source");
}

TEST_F(LandmarkPointFiles, OfAnotherFrameAreRefused) {
    TriangleMesh mesh = make_icosphere(2);
    mesh.vertices.rowwise() += Eigen::RowVector3d(5, -3, 40);
    std::vector<Landmark> landmarks = {{"one", mesh.vertices.row(3)}, {"two", mesh.vertices.row(7)}};
    EXPECT_NO_THROW(require_near(landmarks, mesh, "source"));
    landmarks[1].point[0] += 0.3;  // not quite on the surface
    EXPECT_NO_THROW(require_near(landmarks, mesh, "source"));
    landmarks[1].point[0] += 3;
    test::expect_error<InvalidInput>([&] { require_near(landmarks, mesh, "source"); },
                                     "landmark 'two' of the source lies ");
    landmarks[1].point = mesh.vertices.row(7);
    for (Landmark& landmark : landmarks) landmark.point.head<2>() *= -1;
    test::expect_error<InvalidInput>([&] { landmark_pairs({landmarks}, mesh, {landmarks}, mesh); },
                                     "one of them is LPS, the other RAS");
}

TEST_F(LandmarkPointFiles, WhatIsWrongIsNamed) {
    refused("a.mrk.json", "{", "the JSON is damaged");
    refused("a.mrk.json", "[]", "there are no markups");
    refused("a.mrk.json", R"({"markups":[{"coordinateSystem":"IJK"}]})", "neither LPS nor RAS");
    refused("a.mrk.json", R"({"markups":[{"controlPoints":[{"position":[1,2]}]}]})",
            "point 0 has no three coordinates");
    refused("a.mrk.json", R"({"markups":[{"controlPoints":[{"label":"a"}]}]})", "point 0 has no position");
    refused("a.mrk.json", R"({"markups":[]})", "there are no landmarks");
    refused("a.json", R"([{"id":"a","coordinates":[1,2,"x"]}])", "a coordinate that is no number");
    refused("a.json", "{}", "a list of landmarks");
    refused("a.fcsv", "# CoordinateSystem = 2\n", "a.fcsv:1: the CoordinateSystem is neither");
    refused("a.csv", "name,x,y,z\na,1,2,nan\n", "a.csv:2: a name and three coordinates are expected");
    refused("a.tps", "LM3=0\n", "TPS is written, not read");
    refused("a.txt", "", "must end in .mrk.json");
}

}  // namespace
}  // namespace counterpart
