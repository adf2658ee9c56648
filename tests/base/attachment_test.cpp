// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/attachment.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

TEST(Attachment, IsTheTextOfRfc4648) {
  // Section 10 of the RFC.
  const std::pair<std::string, std::string> known[] = {
    {"f", "Zg=="},        {"fo", "Zm8="},        {"foo", "Zm9v"},
    {"foob", "Zm9vYg=="}, {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : known) {
    EXPECT_EQ(attachment_text({"a.txt", bytes}), "data:a.txt;base64," + text);
    const auto back = read_attachment("data:a.txt;base64," + text);
    ASSERT_TRUE(back) << text;
    EXPECT_EQ(*back, (attachment{"a.txt", bytes}));
  }
}

TEST(Attachment, EveryByteComesBack) {
  attachment file{"all; of, them.bin", {}};
  for (int i = 0; i < 1000; ++i)
    file.bytes += static_cast<char>(i * 7);

  const auto back = read_attachment(attachment_text(file));

  ASSERT_TRUE(back);
  EXPECT_EQ(back->bytes, file.bytes);
  EXPECT_EQ(back->name, "all_ of_ them.bin");
}

TEST(Attachment, WhatIsNoneIsRefused) {
  for (const auto* text :
       {"", "logo.stl", "data:", "data:a", "data:a;base64", "data:a;base64,Zg=", "data:a;base64,Zg",
        "data:a;base64,====", "data:a;base64,Z===", "data:a;base64,Zg==Zg==", "data:a;base64,Zm9!",
        "data:a;base64,Zm 9v"})
    EXPECT_FALSE(read_attachment(text)) << text;
  EXPECT_FALSE(
    read_attachment("data:a;base64," + std::string((most_attached_bytes + 3) / 3 * 4 + 4, 'A')));
}

TEST(Attachment, AFileIsReadWithItsName) {
  const test::scratch_folder folder;
  const auto path = folder.path() / "knob.stl";
  std::ofstream(path) << "foobar";

  const auto text = attach_file(path.string());

  ASSERT_TRUE(text) << render(text.error());
  EXPECT_EQ(*text, "data:knob.stl;base64,Zm9vYmFy");
}

TEST(Attachment, WhatCannotBeReadIsNamed) {
  const test::scratch_folder folder;
  const auto path = folder.path() / "empty.stl";
  std::ofstream(path).close();
  const auto large = folder.path() / "large.stl";
  std::ofstream(large) << std::string(most_attached_bytes + 1, 'x');

  EXPECT_THAT(attach_file((folder.path() / "none").string()).error().message,
              HasSubstr("is not there"));
  EXPECT_THAT(attach_file(folder.path().string()).error().message, HasSubstr("is no file"));
  EXPECT_THAT(attach_file("/dev/zero").error().message, HasSubstr("is no file"));
  EXPECT_THAT(attach_file(path.string()).error().message, HasSubstr("is empty"));
  EXPECT_THAT(attach_file(large.string()).error().message, HasSubstr("more than 4 MiB"));
}

}  // namespace
}  // namespace tedit
