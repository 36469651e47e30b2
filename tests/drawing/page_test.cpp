// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <limpet/drawing/page.hpp>
#include <limpet/drawing/page_data.hpp>
#include <nlohmann/json.hpp>

#include "../model/streams.hpp"

namespace limpet::drawing::testing {
namespace {

using model::testing::Random;

std::string gunzipped(const std::string& bytes, std::size_t most) {
  std::string result(most, '\0');
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, MAX_WBITS + 16), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  inflateEnd(&stream);
  return result;
}

TEST(Page, Base64IsAsInRfc4648) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Page, WhatIsCompressedComesBack) {
  Random random(3);
  for (const std::size_t size : {0u, 1u, 100u, 200'000u}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i)
      bytes.push_back(static_cast<char>(random.below(size % 3 ? 256 : 3)));
    EXPECT_EQ(gunzipped(gzipped(bytes), size + 1), bytes);
    EXPECT_EQ(gzipped(bytes), gzipped(bytes));
  }
}

TEST(Page, TextIsHarmlessInHtml) {
  EXPECT_EQ(html_text("</script><b a='1' c=\"2\">&"),
            "&lt;/script&gt;&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;");
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i)
    value =
        static_cast<Number>(value | static_cast<Number>(static_cast<std::uint8_t>(bytes[at + i])) << (8 * i));
  return value;
}

/// Whatever the length of the head: each array begins at a multiple of 8, and holds what was put there.
TEST(PageData, ArraysAreWhereTheHeadSays) {
  const std::vector<float> floats = {1.5f, -0.25f, 1e-30f};
  const std::vector<std::uint32_t> words = {7, 0xffffffff};
  for (std::size_t pad = 0; pad < 200; pad += 7) {
    PageData data;
    data.put("floats", floats);
    data.put("bytes", std::string("abc"));
    data.put("words", words);
    const std::string bytes = data.bytes(nlohmann::json({{"name", std::string(pad, 'x')}}).dump());
    ASSERT_EQ(bytes.substr(0, 8), "LIMPAGE1");
    const auto head = nlohmann::json::parse(bytes.substr(12, number_at<std::uint32_t>(bytes, 8)));
    EXPECT_EQ(head["name"].get<std::string>().size(), pad);
    for (const auto& array : head["arrays"]) EXPECT_EQ(array["offset"].get<std::size_t>() % 8, 0u);
    const auto offset = [&](const char* name) { return head["arrays"][name]["offset"].get<std::size_t>(); };
    for (std::size_t i = 0; i < floats.size(); ++i)
      EXPECT_EQ(std::bit_cast<float>(number_at<std::uint32_t>(bytes, offset("floats") + 4 * i)), floats[i]);
    EXPECT_EQ(bytes.substr(offset("bytes"), 3), "abc");
    EXPECT_EQ(number_at<std::uint32_t>(bytes, offset("words") + 4), 0xffffffff);
    EXPECT_EQ(head["arrays"]["words"]["length"], 2);
  }
}

/// A name that would end a script, or is no UTF-8, comes through as text.
TEST(Page, HoldsNothingThatCouldRun) {
  try {
    require_page();
  } catch (const NoPage& error) {
    GTEST_SKIP() << error.what();
  }
  const std::string evil = "</script><script>alert(1)</script>\xff";
  PageData data;
  const std::string html = page(evil, data.bytes(nlohmann::json({{"name", "</script>"}}).dump()));
  EXPECT_EQ(html.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(html.find("&lt;/script&gt;&lt;script&gt;alert(1)"), std::string::npos);
  EXPECT_EQ(html.find("{{"), std::string::npos);
  EXPECT_EQ(html, page(evil, data.bytes(nlohmann::json({{"name", "</script>"}}).dump())));
}

}  // namespace
}  // namespace limpet::drawing::testing
