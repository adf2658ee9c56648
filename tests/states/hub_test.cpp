// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents to which nobody gave a name, with the hub, sessions and stores as they are and real
// files.
#include <deque>
#include <filesystem>
#include <fstream>
#include <span>

#include "actors/node/hub.hpp"
#include "actors/pages/page_store.hpp"
#include "actors/session/session.hpp"
#include "actors/store/document_lock.hpp"
#include "actors/store/library.hpp"
#include "tests/simulation/disks.hpp"
#include "tests/simulation/server.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {
namespace {

using std::chrono::hours;
using std::chrono::seconds;

/// Sessions end after two seconds without a client, documents without a name a minute after that.
class Hub : public States {
protected:
  Hub() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
      std::filesystem::path(::testing::TempDir()) / "tedit_hub" / info->name() / "documents";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    start();
  }
  ~Hub() override {
    end();
    std::filesystem::remove_all(folder_.parent_path());
  }

  void start() {
    disks_ = std::make_unique<simulation::simulated_disks>(
      time_, stage_.system(), std::make_shared<simulation::document_record>());
    const auto cache = std::make_shared<page_cache>(std::size_t{1} << 20);
    hub_parts parts{folder_, {}, stage_.system().spawn(make_page_store, cache), cache};
    parts.disks = disks_->disks();
    parts.unused_limit = seconds(2);
    parts.temporary_limit = seconds(60);
    parts.importer = importer_;
    hub_ = stage_.system().spawn(make_hub, parts);
  }

  /// As by kill -9.
  void end() {
    disks_->stop();
    for (const auto& [name, session] : simulation::state_of<hub_state>(hub_).open)
      simulation::cut_off(caf::actor_cast<caf::actor>(session));
    simulation::cut_off(caf::actor_cast<caf::actor>(hub_));
    stage_.drain();
  }

  caf::actor make_client() {
    return stage_.system().spawn(
      [](caf::event_based_actor* self, int) -> caf::behavior {
        self->set_default_handler(caf::drop);
        return {[](doing& one) { one.what(); }};
      },
      0);
  }

  answer<opened_document> open(const std::string& name) {
    const auto got = ask<opened_document>(hub_, name);
    pass(seconds(1));
    return got;
  }

  /// A document has a file from its first change on.
  void put_file(const std::string& name) {
    std::filesystem::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit",
                               folder_ / (name + ".tedit"));
  }

  /// A document without a name of its own, and a client that has it open.
  opened_document open_unnamed() {
    put_file("temporary-1764100000000000000-1");
    auto made = open("temporary-1764100000000000000-1").value();
    attach(made);
    return made;
  }

  void attach(const opened_document& document) {
    const auto got = ask<session_snapshot>(document.session, attach_request{client_});
    pass(milliseconds(10));
    EXPECT_TRUE(got.is_success());
  }

  void leave(const opened_document& document) {
    caf::anon_send(document.session, detach_atom::value, client_);
  }

  [[nodiscard]] bool is_there(const std::string& name) const {
    return std::filesystem::exists(folder_ / (name + ".tedit"));
  }

  std::filesystem::path folder_;
  std::unique_ptr<simulation::simulated_disks> disks_;
  hub_actor hub_;
  part_importer_actor importer_;
  caf::actor client_ = make_client();
};

struct slow_importer_state {
  std::deque<caf::typed_response_promise<part_document>> asked;
  static inline const char* name = "slow_importer";
};

/// With an importer that answers when the test has it.
class HubWithImporter : public Hub {
protected:
  HubWithImporter() {
    slow_ = stage_.system().spawn(
      [](caf::stateful_actor<slow_importer_state>* self, int) -> caf::behavior {
        return {[=](const part_order&) -> caf::result<part_document> {
                  self->state.asked.push_back(self->make_response_promise<part_document>());
                  return self->state.asked.back();
                },
                [](const doing& that) { that.what(); }};
      },
      0);
    importer_ = caf::actor_cast<part_importer_actor>(slow_);
    end();
    start();
  }

  answer<added_document> import(const std::string& name, bool or_next_free = false) {
    auto result = ask<added_document>(hub_, part_request{name, or_next_free, {}});
    pass(milliseconds(1));
    return result;
  }
  std::size_t asked() { return simulation::state_of<slow_importer_state>(slow_).asked.size(); }
  /// The oldest import ends.
  void end_import(const std::function<void(caf::typed_response_promise<part_document>&)>& answer) {
    within(slow_, [=, this] {
      auto& all = simulation::state_of<slow_importer_state>(slow_).asked;
      answer(all.front());
      all.pop_front();
    });
    pass(seconds(1));
  }
  static std::vector<page_ptr> document() {
    std::ifstream in(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    return {page::from_bytes(std::as_bytes(std::span(bytes)))};
  }

  caf::actor slow_;
};

TEST_F(HubWithImporter, TheNameIsHeldWhileAPartIsMeshed) {
  const auto first = import("bracket");
  const auto same = import("bracket");
  EXPECT_EQ(same.refusal().code, ec::conflict) << "nobody waits for a mesh that has no place to go";
  const auto next = import("bracket", true);
  EXPECT_EQ(open("bracket").refusal().code, ec::conflict);
  EXPECT_EQ(asked(), 2U);

  end_import([](auto& promise) { promise.deliver(part_document{document(), {"a note"}}); });
  ASSERT_TRUE(first.is_success()) << render(first.refusal());
  EXPECT_EQ(first.value().name, "bracket");
  EXPECT_THAT(first.value().warnings, ElementsAre("a note"));
  EXPECT_TRUE(open("bracket").is_success());
  end_import([](auto& promise) { promise.deliver(part_document{document(), {}}); });
  EXPECT_EQ(next.value().name, "bracket-2");
}

TEST_F(HubWithImporter, WithoutANameItIsATemporaryDocument) {
  const auto made = import("");
  end_import([](auto& promise) { promise.deliver(part_document{document(), {}}); });
  ASSERT_TRUE(made.is_success());
  const auto name = made.value().name;
  EXPECT_TRUE(is_temporary(name));
  EXPECT_TRUE(open(name).is_success()) << "who asked for it opens it";
  pass(seconds(70));
  EXPECT_FALSE(is_there(name)) << "nobody came";
}

TEST_F(HubWithImporter, ARefusedPartGivesItsNameBack) {
  const auto first = import("bracket");
  end_import([](auto& promise) {
    promise.deliver(to_caf({ec::mesher_failed, "the mesher ended", "Try another size", {}}));
  });
  EXPECT_EQ(first.refusal().code, ec::mesher_failed);
  EXPECT_EQ(first.refusal().remedy, "Try another size");
  EXPECT_FALSE(is_there("bracket"));
  const auto second = import("bracket");
  end_import([](auto& promise) { promise.deliver(part_document{document(), {}}); });
  EXPECT_TRUE(second.is_success());
}

TEST_F(Hub, WithoutAnImporterPartsAreRefusedWithTheWayAround) {
  const auto refused = ask<added_document>(hub_, part_request{"bracket", false, {}});
  pass(seconds(1));
  EXPECT_EQ(refused.refusal().code, ec::service_unavailable);
  EXPECT_THAT(refused.refusal().remedy, HasSubstr("tedit import"));
  EXPECT_FALSE(is_there("bracket"));
}

TEST(TemporaryNames, AreThoseThatTheServerMakes) {
  EXPECT_TRUE(is_temporary("temporary-1764100000000000000-1"));
  for (const auto* name : {"temporary", "temporary-", "temporary-1", "temporary-1-", "temporary--1",
                           "temporary-1-2-3", "temporary-1-x", "my-temporary-1-2", "unnamed-1-2"})
    EXPECT_FALSE(is_temporary(name)) << name;
}

TEST_F(Hub, WhoMayBeginNoneGetsOnlyDocumentsThatAreThere) {
  const auto existing = [&](const std::string& name) {
    const auto got = ask<opened_document>(hub_, existing_atom::value, name);
    pass(seconds(1));
    return got;
  };
  EXPECT_EQ(existing("plate").refusal().code, ec::not_found);
  EXPECT_THAT(existing("plate").refusal().message, HasSubstr("there is no document plate"));
  EXPECT_EQ(existing("").refusal().code, ec::invalid_argument);
  put_file("bracket");
  EXPECT_EQ(existing("bracket").value().name, "bracket");
  EXPECT_TRUE(open("plate").is_success());
  EXPECT_EQ(existing("plate").value().name, "plate") << "it is open, though it has no file yet";
}

TEST_F(Hub, ADocumentWithoutANameGoesAfterItsLastClient) {
  const auto document = open_unnamed();
  pass(hours(5));
  EXPECT_TRUE(is_there(document.name)) << "its client is there";

  leave(document);
  pass(seconds(58));
  EXPECT_TRUE(is_there(document.name));
  pass(seconds(10));

  EXPECT_TRUE(list_folder(folder_).documents.empty());
  const auto refusal = open(document.name).refusal();
  EXPECT_EQ(refusal.code, ec::not_found);
  EXPECT_THAT(refusal.message, HasSubstr("is gone: it had no name of its own"));
  EXPECT_FALSE(refusal.remedy.empty());
  EXPECT_TRUE(list_folder(folder_).documents.empty()) << "no empty one in its place";
}

TEST_F(Hub, EachThatIsOpenedWithoutANameGetsOneOfThese) {
  const auto first = open("").value();
  const auto second = open("").value();

  EXPECT_TRUE(is_temporary(first.name)) << first.name;
  EXPECT_TRUE(is_temporary(second.name)) << second.name;
  EXPECT_NE(first.name, second.name);
  EXPECT_EQ(open(first.name).value().session, first.session);
}

TEST_F(Hub, OneThatNobodyEverCameToGoesToo) {
  put_file("temporary-1764100000000000000-1");
  open("temporary-1764100000000000000-1");
  pass(seconds(70));
  EXPECT_FALSE(is_there("temporary-1764100000000000000-1"));
}

TEST_F(Hub, WhoComesBackInTimeHasItAgainAndLeavesItAnew) {
  const auto first = open_unnamed();
  leave(first);
  pass(seconds(40));

  const auto again = open(first.name).value();
  attach(again);
  pass(hours(2));
  EXPECT_TRUE(is_there(first.name));
  leave(again);
  pass(seconds(58));
  EXPECT_TRUE(is_there(first.name)) << "the time begins anew";
  pass(seconds(10));
  EXPECT_FALSE(is_there(first.name));
}

TEST_F(Hub, ANameOfItsOwnKeepsADocument) {
  const auto document = open_unnamed();
  const auto renamed = ask<acknowledged>(hub_, rename_request{document.session, "bracket"});
  pass(seconds(1));
  ASSERT_TRUE(renamed.is_success()) << render(renamed.refusal());

  leave(document);
  pass(hours(5));

  EXPECT_TRUE(is_there("bracket"));
  EXPECT_EQ(open(document.name).value().name, "bracket") << "by its name of before, too";
}

TEST_F(Hub, ACopyStaysWithoutItsDocument) {
  const auto document = open_unnamed();
  const auto copied = ask<added_document>(hub_, copy_request{document.name, "bracket"});
  pass(seconds(1));
  ASSERT_TRUE(copied.is_success());

  leave(document);
  pass(seconds(70));

  EXPECT_TRUE(is_there("bracket"));
  EXPECT_FALSE(is_there(document.name));
}

TEST_F(Hub, ACopyThatIsCancelledIsNotThereAndItsNameIsFree) {
  put_file("plate");
  const auto cancelled = [&] {
    copy_request wanted{"plate", "bracket"};
    wanted.stop.cancel();
    const auto copied = ask<added_document>(hub_, wanted);
    pass(seconds(1));
    EXPECT_EQ(copied.refusal().code, ec::cancelled);
    EXPECT_EQ(copied.refusal().message, "the copy was cancelled");
    EXPECT_FALSE(is_there("bracket"));
  };
  cancelled();
  ASSERT_TRUE(open("plate").is_success());
  cancelled();

  const auto copied = ask<added_document>(hub_, copy_request{"plate", "bracket"});
  pass(seconds(1));

  EXPECT_TRUE(copied.is_success());
  EXPECT_TRUE(is_there("bracket"));
}

TEST_F(Hub, AfterARestartItsClientHasTimeToComeBack) {
  const auto document = open_unnamed();
  end();
  start();

  pass(seconds(55));
  EXPECT_TRUE(is_there(document.name));
  pass(seconds(10));
  EXPECT_FALSE(is_there(document.name));
}

TEST_F(Hub, OthersStayHoweverLongNobodyHasThemOpen) {
  for (const auto* name : {"bracket", "unnamed-1764100000000000000-1"}) {
    put_file(name);
    const auto document = open(name).value();
    attach(document);
    leave(document);
  }
  pass(hours(48));

  EXPECT_TRUE(is_there("bracket"));
  EXPECT_TRUE(is_there("unnamed-1764100000000000000-1")) << "as versions of before named them";
}

TEST_F(Hub, NobodyGivesADocumentSuchAName) {
  const auto document = open("bracket").value();
  attach(document);

  const auto renamed = ask<acknowledged>(hub_, rename_request{document.session, "temporary-1-1"});
  const auto copied = ask<added_document>(hub_, copy_request{"bracket", "temporary-1-1"});
  const auto added = ask<added_document>(hub_, add_request{"temporary-1-1", false, {}, nullptr});
  pass(seconds(1));

  for (const auto& refusal : {renamed.refusal(), copied.refusal(), added.refusal()}) {
    EXPECT_EQ(refusal.code, ec::invalid_argument);
    EXPECT_THAT(refusal.message, HasSubstr("go after their last client"));
    EXPECT_THAT(refusal.remedy, HasSubstr("another name"));
  }
}

TEST_F(Hub, OneThatAnotherProgramHoldsStays) {
  const auto document = open_unnamed();
  end();
  const auto lock = store::document_lock::take(folder_ / (document.name + ".tedit"));
  ASSERT_TRUE(lock.has_value());
  start();

  pass(seconds(70));

  EXPECT_TRUE(is_there(document.name));
}

}  // namespace
}  // namespace tedit::actors
