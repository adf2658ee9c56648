// SPDX-License-Identifier: AGPL-3.0-or-later
// "tedit certs" as a person or a script uses it.
#include "tests/cli/run_program.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::test {
namespace {

class CertsProgram : public ::testing::Test {
protected:
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder.path() / name).string();
  }
  [[nodiscard]] std::string ca() const { return at("ca"); }

  [[nodiscard]] json done(const std::string& arguments) const {
    const auto result = run("certs " + arguments + " --json");
    EXPECT_EQ(result.status, 0) << arguments << ": " << result.out;
    return result.parsed();
  }

  scratch_folder folder;
};

TEST_F(CertsProgram, MakesIssuesRenewsRevokesAndLists) {
  EXPECT_EQ(done("init " + ca() + " --name 'Hall 3'")["name"], "Hall 3");
  const auto server = done("issue " + ca() +
                           " --role server --name hall --host 10.0.0.7 --host "
                           "hall.example.org --days 30 -o " +
                           at("hall"));
  EXPECT_EQ(server["hosts"], json({"hall", "10.0.0.7", "hall.example.org"}));
  EXPECT_EQ(server["folder"], at("hall"));
  const auto worker =
    done("issue " + ca() + " --role solver --name w --output " + at("w"))["serial"];
  const auto renewed = done("renew " + ca() + " --name w -o " + at("w"))["serial"];
  EXPECT_NE(worker, renewed);
  const auto revoked = done("revoke " + ca() + " --serial " + worker.get<std::string>());
  EXPECT_EQ(revoked["revoked"].size(), 1U);
  EXPECT_EQ(revoked["list"], ca() + "/crl.pem");

  const auto all = done("list " + ca());
  EXPECT_EQ(all["authority"]["name"], "Hall 3");
  ASSERT_EQ(all["certificates"].size(), 3U);
  EXPECT_EQ(all["certificates"][0]["name"], "hall");
  EXPECT_EQ(all["certificates"][0]["role"], "server");
  for (const auto& one : all["certificates"])
    EXPECT_EQ(one["revoked"], one["serial"] == worker) << one;
  const auto text = run("certs list " + ca()).out;
  EXPECT_THAT(text, HasSubstr("valid until"));
  EXPECT_THAT(text, HasSubstr("revoked"));
}

TEST_F(CertsProgram, ErrorsHaveCodesAndStatuses) {
  EXPECT_EQ(run("certs").status, 2);
  EXPECT_EQ(run("certs issue " + ca() + " --role admin --name x").status, 2);
  EXPECT_EQ(run("certs issue " + ca() + " --role solver").status, 2);
  EXPECT_EQ(run("certs issue " + ca() + " --role solver --name x --days 0").status, 2);
  EXPECT_EQ(run("certs revoke " + ca()).status, 2);
  EXPECT_EQ(run("certs revoke " + ca() + " --name a --serial 1").status, 2);

  const auto none = run("certs list " + ca() + " --json");
  EXPECT_NE(none.status, 0);
  EXPECT_EQ(none.parsed()["error"]["code"], "not_found");
  EXPECT_THAT(none.parsed()["error"]["remedy"].get<std::string>(), HasSubstr("certs init"));
  EXPECT_EQ(run("certs init " + ca()).status, 0);
  EXPECT_EQ(run("certs init " + ca() + " --json").parsed()["error"]["code"], "conflict");
}

}  // namespace
}  // namespace tedit::test
