// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

TEST(Text, DoublesAreReadWhole) {
  double value = 0;
  EXPECT_TRUE(parse_double("-1.25e2", value));
  EXPECT_EQ(value, -125);
  EXPECT_TRUE(parse_double("+0.5", value));
  EXPECT_EQ(value, 0.5);
  EXPECT_TRUE(parse_double("nan", value));
  EXPECT_TRUE(std::isnan(value));
  EXPECT_TRUE(parse_double("-inf", value));
  EXPECT_EQ(value, -std::numeric_limits<double>::infinity());
  for (const char* garbage : {"", "1,5", "0x10", "1.5m", "+-1", "1e", "--1", " 1"}) {
    EXPECT_FALSE(parse_double(garbage, value)) << garbage;
  }
}

TEST(Text, DoublesOutOfRangeBecomeInfiniteOrZero) {
  double value = 1;
  EXPECT_TRUE(parse_double("1e999", value));
  EXPECT_EQ(value, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(parse_double("-1e999", value));
  EXPECT_EQ(value, -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(parse_double("-1e-999", value));
  EXPECT_EQ(value, 0);
  EXPECT_TRUE(parse_double(std::string(400, '9'), value));
  EXPECT_EQ(value, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(parse_double("0." + std::string(400, '0') + "1", value));
  EXPECT_EQ(value, 0);
}

TEST(Text, IntegersOf128BitsKeepEveryDigit) {
  const model::Int128 lowest = model::Int128{1} << 127;
  for (const model::Int128 value :
       {model::Int128{0}, model::Int128{-7}, lowest, static_cast<model::Int128>(~lowest)}) {
    std::string text;
    append(text, value);
    model::Int128 read = 1;
    ASSERT_TRUE(parse_integer(text, read)) << text;
    EXPECT_TRUE(read == value) << text;
  }
  std::string text;
  append(text, lowest);
  EXPECT_EQ(text, "-170141183460469231731687303715884105728");
}

TEST(Text, IntegersThatDoNotFitAreRefused) {
  model::Int128 wide = 0;
  EXPECT_FALSE(parse_integer("170141183460469231731687303715884105728", wide));
  EXPECT_FALSE(parse_integer("-", wide));
  EXPECT_FALSE(parse_integer("12a", wide));
  std::int64_t narrow = 0;
  EXPECT_FALSE(parse_integer("9223372036854775808", narrow));
  std::uint64_t positive = 0;
  EXPECT_FALSE(parse_integer("-1", positive));
}

TEST(Text, NoNumberSaysWhatToDo) {
  EXPECT_EQ(no_number("x"), "'x' is not a number");
  EXPECT_NE(no_number("1,5").find("decimal points"), std::string::npos);
  EXPECT_NE(no_number("1\r2").find("carriage return"), std::string::npos);
  EXPECT_NE(no_number("1\n2").find("line feed"), std::string::npos);
  EXPECT_NE(no_number(std::string_view("1\0", 2)).find("UTF-16"), std::string::npos);
}

TEST(Text, ACarriageReturnIsNoBlank) {
  std::string_view rest = " 1\r2\t3 ";
  EXPECT_EQ(next_token(rest), "1\r2");
  EXPECT_EQ(next_token(rest), "3");
  EXPECT_EQ(next_token(rest), "");
  EXPECT_EQ(without_blanks(" \t1 2\r\t "), "1 2\r");
  EXPECT_EQ(without_blanks(" \t "), "");
}

TEST(Text, ExtensionsAreOfTheNameAlone) {
  EXPECT_EQ(extension_of("a.b/scan.PLY"), "ply");
  EXPECT_EQ(extension_of("a.b/scan"), "");
  EXPECT_EQ(extension_of("x.tar.gz"), "gz");
}

}  // namespace
}  // namespace limpet::io
