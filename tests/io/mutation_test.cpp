// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/native.hpp>
#include <limpet/io/scan_writer.hpp>
#include <random>
#include <sstream>

#include "files.hpp"
#include "models.hpp"

namespace limpet::io::testing {
namespace {

class MutationTest : public FileTest {};

/// Changes a file as accidents do: bytes flipped, stretches cut, doubled or overwritten, digits raised, ends
/// lost.
std::string mutated(std::string bytes, std::mt19937_64& random) {
  const auto below = [&](std::size_t limit) {
    return limit == 0 ? 0 : static_cast<std::size_t>(random() % limit);
  };
  const std::size_t times = 1 + below(4);
  for (std::size_t i = 0; i < times && !bytes.empty(); ++i) {
    const std::size_t kind = below(6);
    // Headers matter most: half of the changes go there.
    const std::size_t at =
        below(2) == 0 ? below(std::min<std::size_t>(bytes.size(), 300)) : below(bytes.size());
    const std::size_t length = std::min(1 + below(20), bytes.size() - at);
    if (kind == 0) bytes[at] = static_cast<char>(below(256));
    if (kind == 1) bytes.erase(at, length);
    if (kind == 2) bytes.insert(at, bytes.substr(at, length));
    if (kind == 3) bytes.resize(at);
    if (kind == 4) bytes.replace(at, length, std::string(length, '9'));
    if (kind == 5) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
  }
  return bytes;
}

TEST_F(MutationTest, DamagedScansGiveRecordsOrAnError) {
  ScanRecord record;
  record.has_axis = true;
  record.point.axis = Eigen::Vector3d(0, 0, -1);
  std::vector<std::string> originals;
  for (const auto& [name, ascii] : {std::pair{"b.ply", false}, {"a.ply", true}, {"t.xyz", false}}) {
    ScanWriterOptions options;
    options.ascii = ascii;
    options.labels = true;
    const auto writer = create_scan(path(name), options);
    for (int i = 0; i < 40; ++i) {
      record.point.position = Eigen::Vector3d(i, 0.5 * i, -3);
      record.label = i;
      writer->write(record);
    }
    writer->close();
    originals.push_back(read(path(name)));
  }
  std::string pcd = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 40\nHEIGHT 1\nDATA ";
  std::string points;
  for (int i = 0; i < 120; ++i) put(points, static_cast<float>(i));
  std::string packed;
  for (std::size_t i = 0; i < points.size(); i += 32) packed += '\x1f' + points.substr(i, 32);
  std::string compressed = pcd + "binary_compressed\n";
  put(compressed, static_cast<std::uint32_t>(packed.size()));
  put(compressed, static_cast<std::uint32_t>(points.size()));
  originals.push_back(pcd + "binary\n" + points);
  originals.push_back(compressed + packed);
  for (const std::string& original : originals) {
    ASSERT_EQ(read_scan(write("whole", original)).records.size(), 40u);
  }

  constexpr std::uint64_t kSeed = 20240611;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  int refused = 0, read_whole = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    const std::string bytes = mutated(originals[round % originals.size()], random);
    const ScanResult scan = read_scan(write("mutated", bytes));
    ++(scan.error.empty() ? read_whole : refused);
    // A record takes three bytes at least, "1 2" being no point; LZF makes at most 88 bytes of one.
    EXPECT_LE(scan.records.size() + scan.skipped, 88 * bytes.size() / 3 + 1);
    if (!scan.error.empty()) {
      EXPECT_EQ(scan.error.rfind(path("mutated"), 0), 0u) << scan.error;
      EXPECT_EQ(scan.error.find('\n'), std::string::npos) << scan.error;
    }
    for (const ScanRecord& found : scan.records) {
      ASSERT_TRUE(found.point.position.allFinite());
      ASSERT_NEAR(found.point.axis.norm(), found.has_axis ? 1 : 0, 1e-12);
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(read_whole, 20);
}

TEST_F(MutationTest, DamagedNativeFilesAreRefusedOrReadAsTheyStand) {
  std::ostringstream whole;
  write_native(whole, plate());
  constexpr std::uint64_t kSeed = 977;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    const std::string bytes = mutated(whole.str(), random);
    std::istringstream stream(bytes);
    try {
      const model::ModelRecord model = read_native(stream, "m.limpet");
      // What was accepted holds no more than the file, and reads back to itself.
      std::ostringstream again, twice;
      write_native(again, model);
      EXPECT_LE(again.str().size(), bytes.size() + 16);
      std::istringstream from_again(again.str());
      write_native(twice, read_native(from_again, "again"));
      EXPECT_EQ(again.str(), twice.str());
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).rfind("m.limpet: ", 0), 0u) << error.what();
    }
  }
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace limpet::io::testing
