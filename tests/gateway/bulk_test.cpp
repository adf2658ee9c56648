// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/bulk.hpp"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::gateway {
namespace {

using ::testing::ElementsAre;

/// Keeps what is sent; takes it from its queue when the test says so.
class kept_connection final : public connection {
public:
  void send(frame bytes) override {
    queued_ += bytes->size();
    v1::ServerMessage message;
    ASSERT_TRUE(message.ParseFromString(*bytes));
    sent.push_back(std::move(message));
  }
  std::size_t queued_bytes() const override { return queued_; }
  void authenticated() override {}
  void handled(std::size_t) override {}
  void close(std::uint16_t, std::string) override {}
  std::string peer() const override { return "127.0.0.1:1"; }

  void drain() { queued_ = 0; }

  std::vector<v1::ServerMessage> sent;

private:
  std::size_t queued_ = 0;
};

/// Arrays of 3 x 4, 0, 2 x 8, 1 x 4 and 1 x 8 bytes.
bulk arrays() {
  bulk result;
  auto* stream = result.header.mutable_surface_update()->mutable_stream();
  bulk_builder builder;
  builder.add(stream, "slots", v1::ArrayInfo::UINT32, 1, std::vector<std::uint32_t>{7, 8, 9});
  builder.add(stream, "none", v1::ArrayInfo::FLOAT64, 3, std::vector<double>{});
  builder.add(stream, "x", v1::ArrayInfo::FLOAT64, 1, std::vector<double>{0.25, -1});
  builder.add(stream, "y", v1::ArrayInfo::FLOAT32, 1, std::vector<float>{2});
  builder.add(stream, "ids", v1::ArrayInfo::INT64, 1, std::vector<std::int64_t>{-5});
  builder.finish(result);
  result.stream = stream;
  return result;
}

struct received {
  v1::Stream stream;
  std::string bytes;

  template <class T>
  std::vector<T> read(int array, std::size_t at) const {
    std::vector<T> values(stream.arrays(array).items());
    if (!values.empty())
      std::memcpy(values.data(), bytes.data() + at, values.size() * sizeof(T));
    return values;
  }
};

received send_arrays() {
  const auto line = std::make_shared<kept_connection>();
  outbox out(line);
  out.add([] { return arrays(); });
  out.pump();
  received result;
  for (const auto& message : line->sent)
    if (message.has_chunk())
      result.bytes += message.chunk().data();
    else
      result.stream = message.surface_update().stream();
  EXPECT_EQ(result.stream.bytes(), result.bytes.size());
  return result;
}

TEST(Outbox, ArraysBeginAtMultiplesOfEightBytes) {
  const auto got = send_arrays();
  std::vector<std::uint64_t> offsets;
  for (const auto& array : got.stream.arrays())
    offsets.push_back(array.offset());
  EXPECT_THAT(offsets, ElementsAre(0, 16, 16, 32, 40));
  EXPECT_EQ(got.bytes.size(), 48u);
  EXPECT_THAT(got.read<std::uint32_t>(0, 0), ElementsAre(7, 8, 9));
  EXPECT_THAT(got.read<double>(2, 16), ElementsAre(0.25, -1));
  EXPECT_THAT(got.read<float>(3, 32), ElementsAre(2));
  EXPECT_THAT(got.read<std::int64_t>(4, 40), ElementsAre(-5));
  EXPECT_EQ(got.bytes.substr(12, 4) + got.bytes.substr(36, 4), std::string(8, '\0'));
}

/// A file of so many bytes, in pages.
bulk file_of(std::size_t bytes) {
  bulk result;
  result.stream = result.header.mutable_file_ready()->mutable_stream();
  auto* info = result.stream->add_arrays();
  info->set_type(v1::ArrayInfo::UINT8);
  info->set_components(1);
  info->set_items(bytes);
  result.stream->set_bytes(bytes);
  const auto content = std::make_shared<const std::string>(bytes, 'x');
  for (std::size_t at = 0; at < bytes; at += 60'000)
    result.parts.push_back(
      std::as_bytes(std::span(*content)).subspan(at, std::min<std::size_t>(60'000, bytes - at)));
  result.owner = content;
  return result;
}

TEST(Outbox, CountsWhatIsPreparedForAClientThatDoesNotRead) {
  constexpr std::size_t size = 10'000'000;
  const auto line = std::make_shared<kept_connection>();
  outbox out(line);
  for (int i = 0; i < 3; ++i)
    out.add([] { return file_of(size); }, size);
  EXPECT_EQ(out.prepared(), 3 * size);
  out.pump();
  EXPECT_GE(out.prepared(), 3 * size);  // And the messages around it.
  EXPECT_LT(out.prepared(), 3 * size + 10'000);
  while (out.prepared() > 0) {
    line->drain();
    out.pump();
  }
  EXPECT_LT(line->queued_bytes(), 1u);
}

}  // namespace
}  // namespace tedit::gateway
