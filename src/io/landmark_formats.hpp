// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The formats of counterpart/io/landmark_points.hpp, on the bytes of a whole file; `name` leads messages.
#pragma once

#include <counterpart/io/landmark_points.hpp>

#include <string>
#include <string_view>

namespace counterpart::io {

LandmarkPoints parse_slicer_json(std::string_view bytes, const std::string& name);
LandmarkPoints parse_fcsv(std::string_view bytes, const std::string& name);
LandmarkPoints parse_scalismo_json(std::string_view bytes, const std::string& name);
LandmarkPoints parse_landmark_csv(std::string_view bytes, const std::string& name);

std::string slicer_json_bytes(const LandmarkPoints& points);
std::string fcsv_bytes(const LandmarkPoints& points);
std::string scalismo_json_bytes(const LandmarkPoints& points);
std::string landmark_csv_bytes(const LandmarkPoints& points);
std::string tps_bytes(const LandmarkPoints& points);

}  // namespace counterpart::io
