// Copyright the limpet authors. GPL-3.0-or-later.
#include <fstream>

#include "models.hpp"

namespace limpet::audit {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The line an error names; 0 when there is none.
std::size_t error_line(const std::string& text) {
  try {
    parse_document(text);
  } catch (const DocumentError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("line " + std::to_string(error.line()) + ": ", 0), 0u);
    return error.line();
  }
  return 0;
}

TEST(Document, HoldsEveryField) {
  const Document document = parse_document(
      "limpet 1\n# a comment\nresolution 0.5\nwidening 0.125 2\nsensor 1 2 3\nsensor 4 5 6\nangle "
      "0.125\nnoise 0.25\ntolerance 2\nquantum 0.001\npatience "
      "14\n"
      "grid 0.0625\n"
      "arithmetic float-grid\nrules holes,returns\ncounts 8 9 10 11\nnext 12 13\nsegments 1 1\n"
      "point 3 1 -4 5 6 7 8 9 10 11 170141183460469231731687303715884105727 0 0 -1\n"
      "raw 1\n-4 5 6 0 0 -1 2\n"
      "polygon 4 0 0 0 0 0 0 0 0 0 -170141183460469231731687303715884105728 .5 1.5 2.5\n"
      "chart 1 2 3 4 5 6 7 8 9 10 11 12\nheight 13 14 15\ninitial 16 17 18 19 20 21\n"
      "confirmed 22\n"
      "cycles 1\ncycle 2\n1 -2 3 0\n1e3 4 5 6\nraw 0\nend\n");
  EXPECT_EQ(document.resolution, 0.5);
  EXPECT_EQ(document.widening, 0.125);
  EXPECT_EQ(document.sensors, (std::vector<Vector>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(document.angle, 0.125);
  EXPECT_EQ(document.noise, 0.25);
  EXPECT_EQ(document.tolerance, 2);
  EXPECT_EQ(document.quantum, 0.001);
  EXPECT_EQ(document.patience, 14u);
  EXPECT_EQ(document.step, 0.0625);
  EXPECT_EQ(document.arithmetic, Arithmetic::kFloatGrid);
  EXPECT_EQ(document.rules, "holes,returns");
  EXPECT_EQ(document.points, 8u);
  EXPECT_EQ(document.refused, 9u);
  EXPECT_EQ(document.expired, 10u);
  EXPECT_EQ(document.sets, 11u);
  EXPECT_EQ(document.next_segment, 12u);
  EXPECT_EQ(document.next_edge, 13u);
  ASSERT_EQ(document.point_segments.size(), 1u);
  const Segment& point = document.point_segments[0];
  EXPECT_EQ(point.id, 3u);
  EXPECT_EQ(point.moments.m, 1u);
  EXPECT_TRUE(point.moments.sum[0] == -4 && point.moments.product[4] == 11);
  const Int128 largest = ~(static_cast<Int128>(1) << 127);
  EXPECT_TRUE(point.moments.product[5] == largest);
  EXPECT_EQ(point.axis_sum, (Vector{0, 0, -1}));
  ASSERT_EQ(point.raw.size(), 1u);
  EXPECT_EQ(point.raw[0].position, (Vector{-4, 5, 6}));
  EXPECT_EQ(point.raw[0].returned, 2u);
  ASSERT_EQ(document.polygons.size(), 1u);
  const Polygon& polygon = document.polygons[0];
  EXPECT_TRUE(polygon.moments.product[5] == -largest - 1);
  EXPECT_EQ(polygon.origin, (Vector{1, 2, 3}));
  EXPECT_EQ(polygon.u, (Vector{4, 5, 6}));
  EXPECT_EQ(polygon.v, (Vector{7, 8, 9}));
  EXPECT_EQ(polygon.n, (Vector{10, 11, 12}));
  EXPECT_EQ(polygon.h0, 13);
  EXPECT_EQ(polygon.hx, 14);
  EXPECT_EQ(polygon.hy, 15);
  EXPECT_EQ(polygon.initial_centroid, (Vector{16, 17, 18}));
  EXPECT_EQ(polygon.confirmed, 22u);
  EXPECT_EQ(polygon.initial_normal, (Vector{19, 20, 21}));
  ASSERT_EQ(polygon.cycles.size(), 1u);
  ASSERT_EQ(polygon.cycles[0].size(), 2u);
  EXPECT_EQ(polygon.cycles[0][1].x, 1000);
  EXPECT_EQ(polygon.cycles[0][1].edge, 5u);
  EXPECT_EQ(polygon.cycles[0][1].partner, 6u);
}

TEST(Document, ReadsBackWhatWasWritten) {
  const std::string text = text_of(everything());
  EXPECT_EQ(text_of(parse_document(text)), text);
}

TEST(Document, ReadsNumbersThatAreNotFiniteForTheLawsToName) {
  const std::string text = replaced(text_of(everything()), "height 0 ", "height nan ");
  EXPECT_EQ(broken(parse_document(text)), Names{"finite"});
}

TEST(Document, NamesTheLineOfAnError) {
  const std::string text = text_of(everything());
  EXPECT_EQ(error_line(text), 0u);
  EXPECT_EQ(error_line(""), 1u);
  EXPECT_EQ(error_line("\n"), 1u);
  EXPECT_EQ(error_line("OFF\n"), 1u);
  EXPECT_EQ(error_line(replaced(text, "limpet 1", "limpet 2")) != 0, true);
  EXPECT_EQ(error_line(replaced(text, "resolution", "Resolution")), 2u);
  EXPECT_EQ(error_line(replaced(text, "resolution ", "resolution  ")), 2u);
  EXPECT_EQ(error_line(replaced(text, "angle 0.1", "angle 0.1 ")), 3u);
  EXPECT_EQ(error_line(replaced(text, "angle 0.1", "angle")), 3u);
  EXPECT_EQ(error_line(replaced(text, "noise 0.001", "noise 0.001 0")), 4u);
  EXPECT_EQ(error_line(replaced(text, "noise 0.001", "noise 0,001")), 4u);
  EXPECT_EQ(error_line(replaced(text, "noise 0.001", "# comment\nnoise x")), 5u);
  EXPECT_EQ(error_line(replaced(text, "noise 0.001", "noise 1e999")), 4u);
  EXPECT_NE(error_line(replaced(text, "arithmetic exact", "arithmetic guess")), 0u);
  EXPECT_EQ(error_line(replaced(text, "point 1 3 ", "point -1 3 ")), 12u);
  EXPECT_EQ(error_line(replaced(text, "point 1 3 ", "point 18446744073709551616 3 ")), 12u);
  EXPECT_EQ(error_line(replaced(text, "point 1 3 ", "point 1 3 170141183460469231731687303715884105728 ")),
            12u);
  EXPECT_EQ(error_line(replaced(text, "tolerance 0.05\n", "tolerance 0.05\r\n")), 5u);
}

TEST(Document, NothingFollowsEnd) {
  const std::string text = text_of(empty_document());
  EXPECT_EQ(error_line(text), 0u);
  EXPECT_EQ(error_line(text + "\n"), 13u);
  EXPECT_EQ(error_line(text + "# comment\n"), 13u);
  EXPECT_EQ(error_line(text + "end\n"), 13u);
}

TEST(Document, BelievesNoCount) {
  const std::string text = text_of(everything());
  const std::string huge = "18446744073709551615";
  for (const char* record : {"raw 3", "cycles 3", "cycle 4"}) {
    const std::string keyword(record, std::string(record).find(' ') + 1);
    EXPECT_NE(error_line(replaced(text, record, keyword + huge)), 0u) << record;
    EXPECT_NE(error_line(replaced(text, record, keyword + "1")), 0u) << record;
    EXPECT_NE(error_line(replaced(text, record, keyword + "0")), 0u) << record;
  }
  EXPECT_EQ(broken(parse_document(replaced(text, "segments 1 7", "segments " + huge + " 7"))),
            Names{"segment-count"});
}

TEST(Document, ALineOfMoreThanAMegabyteIsAnError) {
  const std::string text = text_of(everything());
  const auto with_comment = [&](std::size_t length) {
    return "#" + std::string(length - 1, ' ') + "\n" + text;
  };
  const auto with_last = [&](std::size_t length) {
    return text.substr(0, text.size() - 4) + std::string(length, 'x');
  };
  EXPECT_EQ(error_line(with_comment(1 << 20)), 0u);
  EXPECT_EQ(error_line(with_comment((1 << 20) + 1)), 1u);
  EXPECT_EQ(error_line(with_last((1 << 20) - 1)), error_line(with_last((1 << 20) + 1)));
  // A line without an end is not read to its end.
  std::ifstream zeros("/dev/zero", std::ios::binary);
  if (!zeros) GTEST_SKIP() << "no /dev/zero here";
  EXPECT_THROW(parse_document(zeros), DocumentError);
}

TEST(Document, EveryTruncationIsAnError) {
  const std::string text = text_of(everything());
  for (std::size_t length = 0; length + 1 < text.size(); ++length)
    ASSERT_NE(error_line(text.substr(0, length)), 0u) << length;
}

using DocumentFuzz = SeededTest;

// Damaged text is either refused, or read as a document that says the same when written and read again, and
// that can be judged. Most damage to numbers breaks a law.
TEST_F(DocumentFuzz, DamageIsRefusedOrJudged) {
  const std::string text = text_of(everything());
  const std::string alphabet = "0123456789-+.e \n#xnaif";
  int refused = 0, judged_sound = 0, judged_broken = 0;
  for (int run = 0; run < 3000; ++run) {
    std::string damaged = text;
    for (std::int64_t k = uniform(1, 3); k > 0; --k) {
      const auto at = static_cast<std::size_t>(uniform(0, static_cast<std::int64_t>(damaged.size()) - 1));
      const char c = uniform(0, 9) == 0
                         ? static_cast<char>(uniform(-128, 127))
                         : alphabet[static_cast<std::size_t>(uniform(0, std::ssize(alphabet) - 1))];
      switch (uniform(0, 7)) {
        case 0:
          damaged[at] = c;
          break;
        case 1:
          damaged.insert(at, 1, c);
          break;
        case 2:
          damaged.erase(at, static_cast<std::size_t>(uniform(1, 4)));
          break;
        case 3:
          damaged.insert(at, damaged.substr(at / 2, 40));
          break;
        default:
          if (std::isdigit(static_cast<unsigned char>(damaged[at])))
            damaged[at] = static_cast<char>('0' + uniform(0, 9));
      }
    }
    try {
      const Document document = parse_document(damaged);
      ASSERT_EQ(text_of(parse_document(text_of(document))), text_of(document)) << damaged;
      ++(broken(document).empty() ? judged_sound : judged_broken);
    } catch (const DocumentError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(judged_broken, 500);
  EXPECT_LT(judged_sound, 1000);
}

}  // namespace
}  // namespace limpet::audit
