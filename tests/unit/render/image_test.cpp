// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/render/image.hpp>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

TEST(Png, RefusesWhatIsNone) {
    test::expect_error<IoError>([] { decode_png("GIF89a"); }, "PNG");
    const std::string whole = encode_png(Image(40, 30, {0.2, 0.4, 0.6}));
    test::expect_error<IoError>([&] { decode_png(whole.substr(0, whole.size() / 2)); }, "PNG");
    test::expect_error<InvalidInput>([] { Image(0, 5, {1, 1, 1}); }, "pixels");
    test::expect_error<InvalidInput>([] { Image(5, 20000, {1, 1, 1}); }, "pixels");
}

TEST(Png, ReadsBackWhatItWrote) {
    Image image(7, 5, {1, 1, 1});
    image.set(0, 0, {1, 0, 0});
    image.set(6, 4, {0, 0.5, 2});  // beyond the range: clamped
    const Image back = decode_png(encode_png(image));
    EXPECT_EQ(back, image);
    EXPECT_EQ(back.at(6, 4)[2], 1);
    EXPECT_EQ(encode_png(image), encode_png(back));
}

}  // namespace
}  // namespace counterpart::render
