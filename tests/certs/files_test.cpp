// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that are cut off, garbage, of somebody else, or open to others.
#include <unistd.h>

#include <random>

#include "tests/certs/authority_fixture.hpp"

namespace tedit::test {
namespace {

using certs::role;

class AuthorityFiles : public Authority {
protected:
  void SetUp() override {
    Authority::SetUp();
    facts = issued({role::solver, "s"});
  }

  /// What every call says of the authority's folder as it is now.
  [[nodiscard]] error refusal() const {
    const auto result = certs::issue(ca(), {role::solver, "new"}, at("new"));
    EXPECT_FALSE(fs::exists(at("new")));
    EXPECT_FALSE(result.has_value());
    return result ? error{} : result.error();
  }

  certs::certificate facts;
};

TEST_F(AuthorityFiles, WhatIsNoAuthorityIsSaidToBeNone) {
  for (const auto& none : {at("nowhere"), at("s")}) {
    EXPECT_EQ(certs::list(none).error().code, ec::not_found);
    EXPECT_THAT(certs::list(none).error().remedy, HasSubstr("tedit certs init"));
    EXPECT_EQ(certs::issue(none, {role::solver, "x"}, at("x")).error().code, ec::not_found);
    EXPECT_EQ(certs::renew(none, "s", certs::day, at("x")).error().code, ec::not_found);
    EXPECT_EQ(certs::revoke(none, {"s", ""}).error().code, ec::not_found);
  }
}

TEST_F(AuthorityFiles, CutOffAtEachByteIsNoticedAndNamed) {
  for (const std::string& name : {std::string("ca.crt"), std::string("ca.key"),
                                  std::string("crl.pem"), "issued/" + facts.serial + ".crt"}) {
    const auto whole = text_of(ca() / name);
    // Without the line's end the file is whole still.
    for (std::size_t size = 0; size + 1 < whole.size(); size += size < 40 ? 1 : 7) {
      put(ca() / name, whole.substr(0, size));
      const auto said = refusal();
      ASSERT_EQ(said.code, ec::bad_input) << name << " " << size << ": " << render(said);
      ASSERT_THAT(said.message, HasSubstr(name));
      ASSERT_FALSE(said.remedy.empty());
    }
    put(ca() / name, whole);
  }
  EXPECT_TRUE(certs::issue(ca(), {role::solver, "new"}, at("new")).has_value());
}

TEST_F(AuthorityFiles, ChangedBytesNeverMakeAnotherCertificate) {
  const auto file = ca() / "crl.pem";
  value(certs::revoke(ca(), {"s", ""}));
  const auto whole = text_of(file);
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    auto bytes = whole;
    bytes[random() % bytes.size()] = static_cast<char>(random());
    put(file, bytes);
    const auto all = certs::list(ca());  // A change of the text around is none.
    ASSERT_TRUE(!all || all->certificates.front().revoked);
  }
}

TEST_F(AuthorityFiles, GarbageIsRefused) {
  const auto whole = text_of(ca() / "ca.crt");
  for (const std::string& garbage :
       {std::string(), std::string(1000, '\0'), std::string("hello"), whole + whole,
        whole + "-----BEGIN", std::string(2 << 20, 'a')}) {
    put(ca() / "ca.crt", garbage);
    EXPECT_EQ(refusal().code, ec::bad_input) << garbage.size();
  }
  fs::remove(ca() / "ca.crt");
  fs::create_directory(ca() / "ca.crt");
  EXPECT_EQ(refusal().code, ec::bad_input);
}

TEST_F(AuthorityFiles, AKeyThatOthersMayReadIsNotUsed) {
  fs::permissions(ca() / "ca.key", fs::perms(0640));
  const auto said = refusal();
  EXPECT_EQ(said.code, ec::invalid_argument);
  EXPECT_THAT(said.remedy, HasSubstr("chmod 600"));
  EXPECT_TRUE(certs::list(ca()).has_value());  // That needs no key.
}

TEST_F(AuthorityFiles, AKeyWithAPassphraseAsksNobody) {
  put(ca() / "ca.key",
      "-----BEGIN ENCRYPTED PRIVATE KEY-----\nAAAA\n-----END ENCRYPTED PRIVATE KEY-----\n");
  EXPECT_EQ(refusal().code, ec::invalid_argument);
}

TEST_F(AuthorityFiles, FilesOfTwoAuthoritiesAreNotMixed) {
  value(certs::init(at("other")));
  for (const auto* name : {"ca.key", "crl.pem"}) {
    const auto own = text_of(ca() / name);
    put(ca() / name, text_of(at("other") / name));
    EXPECT_EQ(refusal().code, ec::bad_input) << name;
    put(ca() / name, own);
  }
}

TEST_F(AuthorityFiles, AMissingListIsAnErrorAndNotAnEmptyOne) {
  fs::remove(ca() / "crl.pem");
  EXPECT_EQ(refusal().code, ec::io_error);
  EXPECT_EQ(certs::list(ca()).error().code, ec::io_error);
}

TEST_F(AuthorityFiles, WhatAKillLeftIsNoTrouble) {
  put(ca() / ".crl.pem.new", "half");
  put(ca() / "issued" / (".0123456789abcdef.crt.new"), "half");
  fs::create_directory(at(".new.new-AbCdEf"));
  EXPECT_EQ(value(certs::revoke(ca(), {"s", ""})).size(), 1U);
  EXPECT_TRUE(certs::issue(ca(), {role::solver, "new"}, at("new")).has_value());
  EXPECT_EQ(value(certs::list(ca())).certificates.size(), 2U);
}

TEST_F(AuthorityFiles, AFolderThatCannotBeWrittenLeavesNothing) {
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may write anywhere";
  fs::permissions(ca() / "issued", fs::perms(0500));
  EXPECT_EQ(refusal().code, ec::io_error);
  fs::permissions(ca() / "issued", fs::perms(0700));
  EXPECT_EQ(value(certs::list(ca())).certificates.size(), 1U);
}

}  // namespace
}  // namespace tedit::test
