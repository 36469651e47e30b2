// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan as text gives the same model however other programs write it.
#include "program.hpp"

namespace limpet::app {
namespace {

class TextScan : public testing::ProgramTest {
 protected:
  static std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
      text.replace(at, what.size(), by);
    return text;
  }

  std::string model_of(const std::string& scan) const {
    const auto result = run({"model", scan, "-o", path("m.limpet")});
    EXPECT_EQ(result.code, 0) << scan << ": " << result.err;
    return read(path("m.limpet"));
  }
};

TEST_F(TextScan, GivesTheSameModelHoweverItIsWritten) {
  const std::string text = read(scan("cube.xyz", "cube", 5000));
  const std::string model = model_of(path("cube.xyz"));
  const std::size_t first_row = text.find("az\n") + 3;
  const std::string comments = text.substr(0, first_row), rows = text.substr(first_row);
  const std::string decimal_commas = replaced(rows, ".", ",");
  EXPECT_EQ(model_of(write("comma.xyz", comments + decimal_commas)), model);
  EXPECT_EQ(model_of(write("semi.csv", "x;y;z;ax;ay;az\n" + replaced(decimal_commas, " ", ";"))), model);
  EXPECT_EQ(model_of(write("tab.txt", "X\tY\tZ\tax\tay\taz\n" + replaced(decimal_commas, " ", "\t"))), model);
  EXPECT_EQ(model_of(write("csv.csv", "\"X\",\"Y\",\"Z\",\"ax\",\"ay\",\"az\"\n" + replaced(rows, " ", ","))),
            model);
  EXPECT_EQ(model_of(write("cr.xyz", replaced(text, "\n", "\r"))), model);
  EXPECT_EQ(model_of(write("mark.xyz", "\xef\xbb\xbf" + replaced(text, "\n", "\r\n"))), model);
}

TEST_F(TextScan, ThatCanBeReadInTwoWaysIsRefused) {
  for (const std::string& text : std::vector<std::string>{
           "1,5, 2,5, 3,5\n2,5, 2,5, 3,5\n", "1,2,3 0,0,1\n4,5,6 0,0,1\n", "1;;3;4\n1;;3;4\n",
           "1.234,5;2;3\n1.234,5;2;4\n", std::string("\xff\xfe") + "1\t"}) {
    const auto result = run({"model", write("a.xyz", text), "-o", path("m.limpet")});
    expect_refused(result, "a.xyz: ");
    EXPECT_FALSE(exists("m.limpet"));
  }
}

}  // namespace
}  // namespace limpet::app
