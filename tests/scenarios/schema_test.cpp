// SPDX-License-Identifier: AGPL-3.0-or-later
// A program that has nothing but a server's address learns the protocol from it.
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include "protocol/version.hpp"
#include "tedit/v1/envelope.pb.h"
#include "tests/scenarios/http.hpp"
#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

TEST(Schema, IsServedWholeAndDescribesTheMessages) {
  const scratch_folder folder;
  served host(folder);
  const auto answer = get(port_of(host.url()), "/protocol.desc");
  EXPECT_THAT(answer, HasSubstr("200 OK"));
  EXPECT_THAT(answer, HasSubstr("application/x-protobuf"));
  google::protobuf::FileDescriptorSet schema;
  ASSERT_TRUE(schema.ParseFromString(answer.substr(answer.find("\r\n\r\n") + 4)));
  google::protobuf::DescriptorPool pool;
  for (const auto& file : schema.file())  // In an order in which each finds what it imports.
    ASSERT_NE(pool.BuildFile(file), nullptr) << file.name();

  EXPECT_EQ(schema.file_size(), 8);
  for (auto file : schema.file()) {
    google::protobuf::FileDescriptorProto ours;
    const auto* spoken =
      google::protobuf::DescriptorPool::generated_pool()->FindFileByName(file.name());
    ASSERT_NE(spoken, nullptr) << file.name();
    spoken->CopyTo(&ours);
    spoken->CopyJsonNameTo(&ours);
    file.clear_source_code_info();
    EXPECT_EQ(file.SerializeAsString(), ours.SerializeAsString()) << file.name();
  }
  const auto* client_message = pool.FindMessageTypeByName("tedit.v1.ClientMessage");
  ASSERT_NE(client_message, nullptr);
  google::protobuf::SourceLocation comment;
  ASSERT_TRUE(pool.FindMessageTypeByName("tedit.v1.Hello")->GetSourceLocation(&comment));
  EXPECT_THAT(comment.leading_comments, HasSubstr("Introduces the client"));

  // A Hello that such a program writes is one.
  google::protobuf::DynamicMessageFactory factory(&pool);
  const std::unique_ptr<google::protobuf::Message> made(
    factory.GetPrototype(client_message)->New());
  auto* hello =
    made->GetReflection()->MutableMessage(made.get(), client_message->FindFieldByName("hello"));
  hello->GetReflection()->SetUInt32(
    hello, hello->GetDescriptor()->FindFieldByName("protocol_minor"), protocol::minor_version);
  v1::ClientMessage read;
  ASSERT_TRUE(read.ParseFromString(made->SerializeAsString()));
  EXPECT_EQ(read.hello().protocol_minor(), protocol::minor_version);
}

}  // namespace
}  // namespace tedit::test
