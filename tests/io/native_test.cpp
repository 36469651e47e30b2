// Copyright the limpet authors. GPL-3.0-or-later.
#include <fstream>
#include <limits>
#include <limpet/io/native.hpp>
#include <limpet/model/model.hpp>
#include <sstream>
#include <tuple>

#include "files.hpp"
#include "models.hpp"

namespace limpet::io::testing {
namespace {

class NativeTest : public FileTest {};

std::string text_of(const model::ModelRecord& model) {
  std::ostringstream stream;
  write_native(stream, model);
  return stream.str();
}

model::ModelRecord model_of(const std::string& text) {
  std::istringstream stream(text);
  return read_native(stream, "m.limpet");
}

std::string error_of(const std::string& text) {
  try {
    model_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A model with something of everything, and numbers that are hard to keep.
model::ModelRecord rich_model() {
  model::ModelRecord model;
  model.parameters.resolution = 0.1;
  model.parameters.angle_rad = 0.17453292519943295;
  model.parameters.noise = 5e-324;
  model.parameters.tolerance = std::numeric_limits<double>::max();
  model.grid_step = 1.0 / 4096;
  model.arithmetic = "float-grid";
  model.parameters.rules = model::Rules::parse("near,holes");
  model.points = std::numeric_limits<std::int64_t>::max();
  model.refused = 3;
  model.expired = 2;
  model.sets = 1;
  model.next_segment = std::numeric_limits<std::uint64_t>::max();
  model.next_edge = 9;
  model::PointSegmentRecord& point = model.point_segments.emplace_back();
  point.id = 1;
  point.moments.count = 2;
  point.moments.sum = {-1, 0, model::Int128{1} << 100};
  point.moments.product = {model::Int128{1} << 127, 2, -3, 4, -5, ~(model::Int128{1} << 127)};
  point.axis_sum = Eigen::Vector3d(-0.0, 1.0 / 3, 1e300);
  point.raw = {{{-5, 6, std::int64_t{1} << 48}, {0.6, 0, -0.8}, 4}, {{0, 0, 0}, {0, 0, 1}, 0}};
  model::PolygonSegmentRecord& polygon = model.polygon_segments.emplace_back();
  polygon.id = 7;
  polygon.moments.count = 64;
  polygon.chart_origin = Eigen::Vector3d(1e6, -1e-9, 0.3);
  polygon.height = {0.1, -0.2, 0.3};
  polygon.initial_centroid = Eigen::Vector3d(1, 2, 3);
  polygon.cycles = {{{0, 0, 1, 0}, {4096.5, 0, 2, 8}, {0, 1.0 / 3, 3, 0}},
                    {{1, 1, 4, 0}, {1, 2, 5, 0}, {2, 1, 6, 0}}};
  polygon.raw = {{{1, 2, 3}, {0, 1, 0}, 1}};
  return model;
}

TEST_F(NativeTest, TheFileIsAsDocumented) {
  model::ModelRecord model;
  model.parameters.resolution = 0.05;
  model.parameters.angle_rad = 0.25;
  model.parameters.noise = 0.001;
  model.parameters.tolerance = 0.01;
  model.grid_step = 0.0009765625;
  model.arithmetic = "exact";
  model.parameters.rules = model::Rules::thesis();
  model.points = 12;
  model.next_segment = 3;
  model.next_edge = 4;
  model.point_segments.push_back(
      {1, {1, {1, 2, 3}, {1, 2, 3, 4, 6, 9}}, {0, 0, 1}, {{{1, 2, 3}, {0, 0, 1}, 0}}});
  model::PolygonSegmentRecord& polygon = model.polygon_segments.emplace_back();
  polygon.id = 2;
  polygon.cycles = {{{0, 0, 1, 0}, {8, 0, 2, 0}, {0, 8, 3, 0}}};
  EXPECT_EQ(text_of(model),
            "limpet 1\nresolution 0.05\nangle 0.25\nnoise 0.001\ntolerance 0.01\ngrid 0.0009765625\n"
            "arithmetic exact\nrules thesis\ncounts 12 0 0 0\nnext 3 4\nsegments 1 1\n"
            "point 1 1 1 2 3 1 2 3 4 6 9 0 0 1\nraw 1\n1 2 3 0 0 1 0\n"
            "polygon 2 0 0 0 0 0 0 0 0 0 0 0 0 0\nchart 0 0 0 1 0 0 0 1 0 0 0 1\nheight 0 0 0\n"
            "initial 0 0 0 0 0 1\ncycles 1\ncycle 3\n0 0 1 0\n8 0 2 0\n0 8 3 0\nraw 0\nend\n");
}

TEST_F(NativeTest, RoundTripIsByteIdentical) {
  for (const model::ModelRecord& model : {rich_model(), cube(), plate(), ModelMaker().make()}) {
    const std::string text = text_of(model);
    EXPECT_EQ(text_of(model_of(text)), text);
  }
}

TEST_F(NativeTest, EveryFieldComesBack) {
  const model::ModelRecord in = rich_model(), out = model_of(text_of(in));
  EXPECT_EQ(out.parameters.noise, in.parameters.noise);
  EXPECT_EQ(out.parameters.tolerance, in.parameters.tolerance);
  EXPECT_EQ(out.parameters.rules.to_string(), in.parameters.rules.to_string());
  EXPECT_EQ(out.points, in.points);
  EXPECT_EQ(out.next_segment, in.next_segment);
  ASSERT_EQ(out.point_segments.size(), 1u);
  EXPECT_TRUE(out.point_segments[0].moments.product == in.point_segments[0].moments.product);
  EXPECT_TRUE(std::signbit(out.point_segments[0].axis_sum.x()));
  EXPECT_EQ(out.point_segments[0].raw[0].at, in.point_segments[0].raw[0].at);
  EXPECT_EQ(out.point_segments[0].raw[0].returned, 4);
  ASSERT_EQ(out.polygon_segments.size(), 1u);
  EXPECT_EQ(out.polygon_segments[0].chart_origin, in.polygon_segments[0].chart_origin);
  EXPECT_EQ(out.polygon_segments[0].height, in.polygon_segments[0].height);
  ASSERT_EQ(out.polygon_segments[0].cycles.size(), 2u);
  EXPECT_EQ(out.polygon_segments[0].cycles[0][1].x, 4096.5);
  EXPECT_EQ(out.polygon_segments[0].cycles[0][1].partner, 8u);
}

TEST_F(NativeTest, LinesThatAreLeftOutWhereTheyAreUsualComeBack) {
  model::ModelRecord in = rich_model();
  for (const char* word : {"\nquantum ", "\npatience ", "\nneighbours ", "\nredundant ", "\nconfirmed "}) {
    EXPECT_EQ(text_of(in).find(word), std::string::npos) << word;
  }
  in.parameters.input_quantum = 0.001;
  in.parameters.outlier_patience = 5000;
  in.parameters.neighbours = false;
  in.parameters.redundancy_count = 80;
  in.parameters.redundancy_ratio = 0.2;
  in.redundant_by_count = 3;
  in.redundant_by_position = 4;
  in.polygon_segments[0].confirmed = 5;
  const model::ModelRecord out = model_of(text_of(in));
  EXPECT_NE(text_of(in).find("\nquantum 0.001\npatience 5000\nneighbours 0 80 0.2\ngrid "),
            std::string::npos);
  EXPECT_EQ(out.parameters.input_quantum, in.parameters.input_quantum);
  EXPECT_EQ(out.parameters.outlier_patience, in.parameters.outlier_patience);
  EXPECT_EQ(out.parameters.neighbours, in.parameters.neighbours);
  EXPECT_EQ(out.parameters.redundancy_count, in.parameters.redundancy_count);
  EXPECT_EQ(out.parameters.redundancy_ratio, in.parameters.redundancy_ratio);
  EXPECT_EQ(out.redundant_by_count, in.redundant_by_count);
  EXPECT_EQ(out.redundant_by_position, in.redundant_by_position);
  EXPECT_EQ(out.polygon_segments[0].confirmed, 5);
  EXPECT_EQ(text_of(out), text_of(in));
}

/// A field that is added has no name here, and does not compile.
auto fields(const model::Parameters& p) {
  const auto& [resolution, growth, sensors, angle_rad, noise, per_range, per_range2, quantum, tolerance,
               patience, count, ratio, neighbours, rules] = p;
  return std::tuple(resolution, growth, sensors, angle_rad, noise, per_range, per_range2, quantum, tolerance,
                    patience, count, ratio, neighbours, rules.to_string());
}

TEST_F(NativeTest, NoParameterIsLostBetweenModelAndFile) {
  model::Parameters unusual{
      0.07, 0.05, {{1, 2, 3}, {4, 5, 6}}, 0.2, 0.001, 0.002, 0.003, 0.0005, 0.02, 4321, 30, 0.1, false, {}};
  unusual.rules = model::Rules::parse("-near,-expiry");
  const model::Model model(unusual);
  const model::Model again(model_of(text_of(model.record())));
  EXPECT_EQ(fields(again.parameters()), fields(unusual));
  EXPECT_EQ(text_of(again.record()), text_of(model.record()));
  const model::Model usual(model::Parameters{});
  EXPECT_EQ(fields(model::Model(usual.record()).parameters()), fields({}));
}

TEST_F(NativeTest, CommentsAreReadOver) {
  std::string text = text_of(cube());
  text.insert(text.find("polygon"), "# a note\n#\n");
  EXPECT_EQ(text_of(model_of("# first\n" + text)), text_of(cube()));
}

TEST_F(NativeTest, EveryTruncationIsRefused) {
  const std::string text = text_of(rich_model());
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(error_of(text.substr(0, size)), "") << "cut to " << size << " bytes";
  }
}

/// The text with its nth field of the first line that begins with the word replaced.
std::string with_field(const std::string& text, const std::string& word, int n, const std::string& value) {
  std::size_t begin = text.find("\n" + word + " ") + 1;
  for (int i = 0; i < n; ++i) begin = text.find(' ', begin) + 1;
  return std::string(text).replace(begin, text.find_first_of(" \n", begin) - begin, value);
}

/// docs/native_format.md, "Limits": at each of them a file is read, beyond it it is refused.
TEST_F(NativeTest, NumbersBeyondWhatAModelHoldsAreRefused) {
  const std::string text = text_of(rich_model());  // its grid step is 1/4096
  const std::string vertex = "4096.5";
  struct Limit {
    const char* word;
    int field;
    const char *most, *more, *says;
  };
  const Limit limits[] = {
      {"height", 1, "562949953421312", "562949953421313", "farther than 2^49 grid steps"},
      {"height", 1, "562949953421312", "1e20", "farther than 2^49 grid steps"},
      {"height", 1, "-562949953421312", "-1e308", "farther than 2^49 grid steps"},
      {"height", 2, "1", "1.0000001", "too steep"},
      {"height", 3, "-1", "-1e20", "too steep"},
      {"chart", 1, "137438953472", "137438953472.5", "farther than 2^49 grid steps"},
      {"chart", 3, "-137438953472", "-1e30", "farther than 2^49 grid steps"},
      {"chart", 4, "2", "2.5", "no coordinate of a unit vector"},
      {"chart", 12, "-2", "-1e308", "no coordinate of a unit vector"},
      {"initial", 2, "137438953472", "1e12", "farther than 2^49 grid steps"},
      {"initial", 6, "2", "1e9", "no coordinate of a unit vector"},
      {vertex.c_str(), 0, "562949953421312", "1e15", "farther than 2^49 grid steps"},
      {vertex.c_str(), 1, "-562949953421312", "-1e15", "farther than 2^49 grid steps"},
      {"-5", 0, "562949953421312", "9223372036854775807", "farther than 2^49 grid steps"},
      {"-5", 1, "-562949953421312", "-9223372036854775808", "farther than 2^49 grid steps"},
      {"-5", 3, "2", "1e300", "no coordinate of a unit vector"},
  };
  for (const Limit& l : limits) {
    SCOPED_TRACE(std::string(l.word) + " field " + std::to_string(l.field));
    EXPECT_EQ(error_of(with_field(text, l.word, l.field, l.most)), "");
    const std::string error = error_of(with_field(text, l.word, l.field, l.more));
    EXPECT_NE(error.find(l.says), std::string::npos) << error;
    EXPECT_NE(error.find("docs/native_format.md"), std::string::npos) << error;
  }
  EXPECT_NE(error_of(with_field(text, "grid", 1, std::to_string(0x1p521))), "");
  EXPECT_NE(error_of(with_field(text, "grid", 1, "9.88131291682493e-324")), "");
}

TEST_F(NativeTest, ALineOfMoreThanAMegabyteIsRefused) {
  const std::string text = text_of(cube());
  const auto comment = [](std::size_t length) { return "#" + std::string(length - 1, 'x') + "\n"; };
  EXPECT_EQ(error_of(comment(1 << 20) + text), "");
  EXPECT_NE(error_of(comment((1 << 20) + 1) + text).find("line 1: longer than 1 MiB"), std::string::npos);
  EXPECT_NE(error_of(std::string(3 << 20, 'x')).find("line 1: longer than 1 MiB"), std::string::npos);
  EXPECT_NE(error_of(std::string(1 << 10, 'x')).find("ends within a line"), std::string::npos);
  std::ifstream zeros("/dev/zero", std::ios::binary);
  if (!zeros) GTEST_SKIP() << "no /dev/zero here";
  EXPECT_THROW(read_native(zeros, "zeros"), InputError);
}

TEST_F(NativeTest, DamageIsNamedWithItsLine) {
  const std::string text = text_of(cube());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = text;
    return error_of(bytes.replace(bytes.find(from), from.size(), to));
  };
  const auto expect = [](const std::string& error, const std::string& says) {
    EXPECT_NE(error.find(says), std::string::npos) << "'" << error << "' does not say '" << says << "'";
  };
  expect(error_of(""), "m.limpet: the file is empty");
  expect(changed("limpet 1", "limpet 2"), "line 1: version '2'");
  expect(changed("limpet 1", "OFF"), "line 1: expected 'limpet', found 'OFF'");
  expect(changed("resolution 0.0625", "resolution 0,0625"), "line 2: '0,0625' is not a number");
  expect(changed("resolution 0.0625", "resolution  0.0625"), "line 2: '' is not a number");
  expect(changed("resolution 0.0625", "resolution inf"), "line 2: 'inf' is not a finite number");
  expect(changed("grid 0.0009765625", "grid 0.001"), "line 6: the grid step is not a power of two");
  expect(changed("grid 0.0009765625", "grid -1"), "line 6: the grid step is not a power of two");
  expect(changed("arithmetic exact", "arithmetic guessed"), "line 7: the arithmetic 'guessed'");
  expect(changed("rules thesis", "rules holes,near"), "line 8: the rules 'holes,near' are not in the order");
  expect(changed("rules thesis", "rules near,nonsense"),
         "line 8: the rules 'near,nonsense' are not all known");
  expect(changed("grid", "patience -1\ngrid"), "line 6: a count is negative");
  expect(changed("counts 600 0 0 0", "counts 600 0 0"), "line 9: a field is missing");
  expect(changed("counts 600 0 0 0", "counts 600 0 0 0 0"), "line 9: more fields");
  expect(changed("counts 600", "counts -600"), "line 9: a count is negative");
  expect(changed("next 7", "next 18446744073709551616"),
         "line 10: '18446744073709551616' is not a whole number");
  expect(changed("segments 0 6", "segments 0 7"), "expected 'polygon', found 'end'");
  expect(changed("segments 0 6", "segments 0 5"), "expected 'end', found 'polygon'");
  expect(changed("segments 0 6", "segments 0 99999999999999"), "expected 'polygon', found 'end'");
  expect(changed("cycle 4", "cycle 5"), "is not a number");
  expect(changed("limpet 1\n", "limpet 1\r\n"), "line 1: version");
  expect(error_of(text + "\n"), "something follows 'end'");
  expect(error_of(text + "# comment\n"), "something follows 'end'");
}

TEST_F(NativeTest, FilesAreWrittenAsideAndReadByName) {
  save_native(path("m.limpet"), rich_model());
  EXPECT_EQ(names(), std::vector<std::string>{"m.limpet"});
  EXPECT_EQ(read(path("m.limpet")), text_of(rich_model()));
  EXPECT_EQ(text_of(load_native(path("m.limpet"))), text_of(rich_model()));
  EXPECT_THROW(load_native(path("other.limpet")), InputError);
  EXPECT_THROW(load_native(path("")), InputError);
  EXPECT_THROW(save_native(path("no/folder.limpet"), rich_model()), OutputError);
}

TEST_F(NativeTest, WordsTheFormatCannotHoldAreRefusedUnwritten) {
  model::ModelRecord model = cube();
  for (const char* word : {"two words", ""}) {
    model.arithmetic = word;
    EXPECT_THROW(save_native(path("m.limpet"), model), std::invalid_argument);
  }
  EXPECT_EQ(names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace limpet::io::testing
