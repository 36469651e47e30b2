// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/scan_writer.hpp>
#include <random>

#include "files.hpp"

namespace limpet::io::testing {
namespace {

class ScanWriterTest : public FileTest {};

std::vector<ScanRecord> random_records(int count) {
  std::mt19937_64 random(7);
  const auto number = [&] { return static_cast<double>(static_cast<std::int64_t>(random())) / 9.0e15; };
  std::vector<ScanRecord> records;
  for (int i = 0; i < count; ++i) {
    ScanRecord& record = records.emplace_back();
    for (int k = 0; k < 3; ++k) record.point.position[k] = number();
    for (int k = 0; k < 3; ++k) record.point.axis[k] = number();
    record.point.axis.normalize();
    record.has_axis = true;
    record.point.range = i % 7 == 0 ? 0 : std::abs(number());
    record.label = i % 5 - 1;
  }
  return records;
}

TEST_F(ScanWriterTest, EveryFormatReadsBackToTheSameBits) {
  const std::vector<ScanRecord> records = random_records(1000);
  for (const auto& [name, ascii] : {std::pair{"b.ply", false}, {"a.ply", true}, {"t.xyz", false}}) {
    SCOPED_TRACE(name);
    ScanWriterOptions options;
    options.ascii = ascii;
    options.labels = options.ranges = true;
    options.comment = "two\nlines";
    const auto writer = create_scan(path(name), options);
    for (const ScanRecord& record : records) writer->write(record);
    EXPECT_FALSE(std::filesystem::exists(path(name))) << "nothing under the final name before close()";
    writer->close();
    const ScanResult scan = read_scan(path(name));
    EXPECT_EQ(scan.error, "");
    EXPECT_EQ(scan.skipped, 0);
    ASSERT_EQ(scan.records.size(), records.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
      EXPECT_EQ(scan.records[i].point.position, records[i].point.position);
      EXPECT_EQ(scan.records[i].point.axis, records[i].point.axis);
      EXPECT_EQ(scan.records[i].point.range, records[i].point.range);
      EXPECT_EQ(scan.records[i].label, records[i].label);
    }
  }
}

TEST_F(ScanWriterTest, AxesAndLabelsMayBeLeftOut) {
  ScanWriterOptions options;
  options.axes = false;
  const auto writer = create_scan(path("p.ply"), options);
  writer->write(random_records(1)[0]);
  writer->close();
  const ScanResult scan = read_scan(path("p.ply"));
  ASSERT_EQ(scan.records.size(), 1u);
  EXPECT_FALSE(scan.records[0].has_axis);
  EXPECT_EQ(scan.records[0].label, -1);
}

TEST_F(ScanWriterTest, AnEmptyScanIsAScan) {
  for (const char* name : {"e.ply", "e.xyz"}) {
    create_scan(path(name), {})->close();
    const ScanResult scan = read_scan(path(name));
    EXPECT_EQ(scan.error, "") << name;
    EXPECT_EQ(scan.records.size(), 0u) << name;
  }
}

TEST_F(ScanWriterTest, WithoutCloseNothingIsLeftAndTheOldFileStays) {
  write("old.ply", "as it was");
  {
    const auto writer = create_scan(path("old.ply"), {});
    for (const ScanRecord& record : random_records(100)) writer->write(record);
  }
  EXPECT_EQ(read(path("old.ply")), "as it was");
  EXPECT_EQ(names(), std::vector<std::string>{"old.ply"});
}

TEST_F(ScanWriterTest, LinksStayLinksAndDevicesStayDevices) {
  write("real.xyz", "");
  std::filesystem::create_symlink(path("real.xyz"), path("link.xyz"));
  std::filesystem::create_symlink("/dev/null", path("null.xyz"));
  for (const char* name : {"link.xyz", "null.xyz"}) {
    const auto writer = create_scan(path(name), {});
    writer->write(random_records(1)[0]);
    writer->close();
    EXPECT_TRUE(std::filesystem::is_symlink(path(name))) << name;
  }
  EXPECT_EQ(read_scan(path("real.xyz")).records.size(), 1u);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(ScanWriterTest, WhatCannotBeWrittenIsSaid) {
  EXPECT_THROW(create_scan(path("scan.las"), {}), OutputError);
  EXPECT_THROW(create_scan(path("no/such/folder.ply"), {}), OutputError);
  std::filesystem::create_directory(path("folder.ply"));
  EXPECT_THROW(create_scan(path("folder.ply"), {}), OutputError);
  ScanWriterOptions options;
  options.labels = true;
  ScanRecord record = random_records(1)[0];
  record.label = std::int64_t{1} << 40;
  EXPECT_THROW(create_scan(path("l.ply"), options)->write(record), std::invalid_argument);
}

}  // namespace
}  // namespace limpet::io::testing
