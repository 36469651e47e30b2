// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/app/arguments.hpp>

namespace limpet::app {
namespace {

TEST(Arguments, NoiseIsPrintedAsItIsTyped) {
  for (const survey::NoiseLaw& noise : {survey::NoiseLaw{0.0012, 0, 0}, {0, 0.002, 0}, {0.001, 0, 0.0014}}) {
    const survey::NoiseLaw read = parse_noise("--noise", short_text(noise));
    EXPECT_EQ(read.fixed, noise.fixed);
    EXPECT_EQ(read.per_range, noise.per_range);
    EXPECT_EQ(read.per_range2, noise.per_range2);
  }
}

}  // namespace
}  // namespace limpet::app
