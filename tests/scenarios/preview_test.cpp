// SPDX-License-Identifier: AGPL-3.0-or-later
// What an edit would make, without making it: nothing is kept, nothing waits for it, and the edit
// that follows is the one that was shown.
#include <atomic>
#include <fstream>
#include <future>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

/// Names and bytes of what a folder holds.
std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> result;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(file.path(), std::ios::binary);
    result[file.path().filename().string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return result;
}

class Preview : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host;
  std::unique_ptr<client::client> user;
  std::atomic<int> events_of_others = 0;
  std::unique_ptr<client::client> other;
  client::committed imported;

  /// `rule`: how the operation rule_breaker behaves; it waits for its cancel else.
  void begin(bool processes, const char* rule = "waits") {
    setenv("TEDIT_PLUGIN_PATH", TEDIT_RULE_BREAKER, 1);
    setenv("TEDIT_BREAK", rule, 1);
    host = start(options_for(folder, processes));
    user = connect(host->url());
    value(user->open("plate", true, true));
    imported = value(user->import_file(plate_mesh, "mm", {}));
    value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
    value(user->wait_surface(imported.head.version_id, patience));
    client::events handlers;
    handlers.on_committed = [this](const auto&) { ++events_of_others; };
    other = connect(host->url(), handlers);
    value(other->open("plate", false, false));
  }

  void TearDown() override {
    unsetenv("TEDIT_PLUGIN_PATH");
    unsetenv("TEDIT_BREAK");
  }

  expected<client::edit_preview> look(const std::vector<surface_id>& hole,
                                      const execution& run = {}) {
    return user->preview_edit("fill_hole", hole, {}, run);
  }

  /// A preview that ends only when it is ended, on its way; returns once its plugin runs.
  std::future<expected<client::edit_preview>> hold(client::client& by, const cancel_token& cancel) {
    auto runs = std::make_shared<std::promise<void>>();
    execution run;
    run.cancel = cancel;
    run.progress = [runs, told = std::make_shared<bool>(false)](double, std::string_view) {
      if (!std::exchange(*told, true))
        runs->set_value();
    };
    auto held = std::async(std::launch::async,
                           [&by, run] { return by.preview_edit("rule_breaker", {5}, {}, run); });
    EXPECT_EQ(runs->get_future().wait_for(patience), std::future_status::ready);
    return held;
  }

  void expect_untouched() {
    const auto all = value(user->get_history());
    ASSERT_EQ(all.versions.size(), 1U);
    EXPECT_EQ(all.versions.front().version_id, imported.head.version_id);
    EXPECT_EQ(events_of_others, 0);
  }

  static ec code_of(const expected<client::edit_preview>& result) {
    return result ? ec::internal : result.error().code;
  }
};

TEST_F(Preview, ShowsWhatTheEditMakesAndKeepsNothing) {
  begin(false);
  const auto before = contents(folder.path());

  const auto shown = value(look({1, 2}));

  EXPECT_EQ(contents(folder.path()), before);
  expect_untouched();
  EXPECT_EQ(user->surface().version_id(), imported.head.version_id);
  EXPECT_EQ(shown.surface.base_version_id, imported.head.version_id);
  auto surface = user->surface();
  value(surface.apply(shown.surface));
  EXPECT_EQ(surface.total_facets(), shown.boundary_facets);

  const auto made = value(user->edit("fill_hole", {1, 2}, {}, {}));
  EXPECT_EQ(made.head.version_id, shown.surface.version_id);
  EXPECT_EQ(made.head.tets, shown.tets);
  EXPECT_EQ(made.head.vertices, shown.vertices);
  EXPECT_EQ(made.load_cases.size(), shown.load_cases.size());
  EXPECT_EQ(made.report->volume_change, shown.report.volume_change);
  EXPECT_EQ(made.report->receipt.size(), shown.report.receipt.size());
  EXPECT_EQ(made.report->surface_map.size(), shown.report.surface_map.size());
  value(user->wait_surface(made.head.version_id, patience));
  expect_same(surface, user->surface());
}

TEST_F(Preview, TheEditTakesItOverAndIsTheSameAsOneWithout) {
  begin(true);
  const auto plain = value(user->edit("fill_hole", {1, 2}, {}, {}));
  value(user->undo());
  const auto shown = value(look({1, 2}));

  const auto made = value(user->edit("fill_hole", {1, 2}, {}, {}));

  EXPECT_EQ(made.head.version_id, plain.head.version_id);
  EXPECT_EQ(made.head.number, 2U);
  // Measured times never repeat to the last bit: nothing was made again.
  EXPECT_EQ(made.report->operation_ms, shown.report.operation_ms);
  EXPECT_EQ(made.report->check_ms, shown.report.check_ms);
  EXPECT_NE(made.report->total_ms, shown.report.total_ms);
  EXPECT_NE(plain.report->operation_ms, shown.report.operation_ms);
}

/// What is committed after drafts is what a preview-less edit makes.
TEST_F(Preview, ADraftIsTheSurfaceAloneAndNoEditTakesItOver) {
  begin(true);
  const std::vector<surface_id> top{98};
  const ops::parameters drill{{"diameter", 0.02}, {"depth", 0.01}};
  const auto plain = value(user->edit("drill", top, drill, {}));
  value(user->undo());
  const auto ask = [&](client::preview_kind kind) {
    return value(user->preview_edit("drill", top, drill, {}, {}, {}, kind));
  };

  const auto draft = ask(client::preview_kind::draft);
  EXPECT_TRUE(draft.draft);
  EXPECT_EQ(draft.tets, 0U);
  EXPECT_FALSE(draft.report.ratios);
  EXPECT_TRUE(draft.report.figures.empty());
  EXPECT_NEAR(draft.report.volume_change, plain.report->volume_change, 1e-12);
  EXPECT_FALSE(draft.report.surface_map.empty());
  EXPECT_EQ(draft.load_cases.size(), plain.load_cases.size());
  auto surface = user->surface();
  value(surface.apply(draft.surface));
  EXPECT_EQ(surface.total_facets(), draft.boundary_facets);

  const auto made = value(user->edit("drill", top, drill, {}));
  EXPECT_EQ(made.head.version_id, plain.head.version_id);
  EXPECT_NE(made.head.version_id, draft.surface.version_id);
  value(user->undo());
  const auto whole = ask(client::preview_kind::whole);
  EXPECT_FALSE(whole.draft);
  EXPECT_FALSE(ask(client::preview_kind::draft).draft) << "the whole one is at hand";
  EXPECT_EQ(value(user->edit("drill", top, drill, {})).report->operation_ms,
            whole.report.operation_ms);
}

TEST_F(Preview, IsNotTakenOverForOtherValuesLoadsOrHeads) {
  begin(false);
  const auto shown = value(look({1, 2}));
  auto loads = value(protocol::load_case_from_file(plate_loads));
  loads.name = "another";

  value(user->set_load_case(loads));
  const auto made = value(user->edit("fill_hole", {1, 2}, {}, {}));

  EXPECT_EQ(made.head.version_id, shown.surface.version_id);
  EXPECT_EQ(made.load_cases.size(), 2U) << "the second came after the preview";
  const auto moving =
    user->edit("fill_hole", {92, 93}, {}, {}, {}, {fem::load_policy::move, false});
  EXPECT_EQ(value(moving).report->loads.policy, fem::load_policy::move);
}

TEST_F(Preview, IsRefusedAsTheEditIs) {
  begin(false);
  const auto same = [&](const error& shown, const error& made) {
    EXPECT_EQ(render(shown), render(made));
    EXPECT_FALSE(shown.message.empty());
  };

  same(look({5}).error(), user->edit("fill_hole", {5}, {}, {}).error());
  same(user->preview_edit("fil_hole", {1}, {}, {}).error(),
       user->edit("fil_hole", {1}, {}, {}).error());
  const std::string stale(32, '0');
  same(user->preview_edit("fill_hole", {1, 2}, {}, {}, stale).error(),
       user->edit("fill_hole", {1, 2}, {}, {}, stale).error());
  expect_untouched();
}

TEST_F(Preview, LooksForTheMostThatWorksWhereItIsAskedTo) {
  begin(false);
  const auto too_deep = [&](bool find_most) {
    return user
      ->preview_edit("erode", {7}, {{"depth", 0.5}}, {}, {}, {},
                     find_most ? client::preview_kind::whole_or_most : client::preview_kind::whole)
      .error();
  };

  const auto plain = too_deep(false);
  const auto found = too_deep(true);

  EXPECT_FALSE(plain.most);
  ASSERT_TRUE(found.most) << render(found);
  EXPECT_EQ(found.most->parameter, "depth");
  value(user->preview_edit("erode", {7}, {{"depth", found.most->value}}, {}));
  expect_untouched();
}

TEST_F(Preview, ANewerOneOfTheConnectionEndsIt) {
  begin(true);
  auto held = hold(*user, {});

  const auto shown = value(look({1, 2}));

  EXPECT_EQ(code_of(held.get()), ec::superseded);
  EXPECT_EQ(shown.surface.base_version_id, imported.head.version_id);
  expect_untouched();
}

TEST_F(Preview, OnesOfOtherConnectionsDoNot) {
  begin(false);
  cancel_token cancel;
  auto held = hold(*user, cancel);

  auto asked = std::async(std::launch::async, [&] {
    return other->preview_edit("fill_hole", {1, 2}, {}, {});
  });
  EXPECT_EQ(held.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
  cancel.cancel();

  EXPECT_EQ(code_of(held.get()), ec::cancelled);
  EXPECT_TRUE(asked.get().has_value());
}

TEST_F(Preview, ACancelEndsItAtOnce) {
  begin(true);
  cancel_token cancel;
  auto held = hold(*user, cancel);

  cancel.cancel();

  EXPECT_EQ(code_of(held.get()), ec::cancelled);
  expect_untouched();
  EXPECT_TRUE(look({1, 2}).has_value());
}

TEST_F(Preview, AnEditEndsItAndIsMade) {
  begin(true);
  auto held = hold(*user, {});

  const auto made = value(other->edit("fill_hole", {1, 2}, {}, {}));

  EXPECT_EQ(code_of(held.get()), ec::superseded);
  EXPECT_EQ(made.head.number, 1U);
}

TEST_F(Preview, UndoEndsItAndMovesTheHead) {
  begin(true);
  value(user->edit("fill_hole", {1, 2}, {}, {}));
  auto held = hold(*user, {});

  EXPECT_EQ(value(other->undo()).head.number, 0U);

  EXPECT_EQ(code_of(held.get()), ec::superseded);
}

TEST_F(Preview, AnEditOfAnotherDocumentGoesBeforeIt) {
  begin(true);
  auto third = connect(host->url());
  value(third->open("other", false, false));
  auto held = hold(*user, {});

  value(third->import_file(plate_mesh, "mm", {}));

  const auto ended = held.get();
  EXPECT_EQ(code_of(ended), ec::superseded);
  EXPECT_THAT(ended.error().message, HasSubstr("gave way"));
  EXPECT_EQ(value(third->edit("fill_hole", {1, 2}, {}, {})).head.number, 1U);
  expect_untouched();
}

TEST_F(Preview, IsNotBegunWhileTheDocumentIsChanged) {
  begin(false);
  cancel_token cancel;
  execution run;
  run.cancel = cancel;
  std::promise<void> runs;
  run.progress = [&, told = false](double, std::string_view) mutable {
    if (!std::exchange(told, true))
      runs.set_value();
  };
  auto edit =
    std::async(std::launch::async, [&] { return user->edit("rule_breaker", {1}, {}, run); });
  runs.get_future().wait();

  const auto refused = other->preview_edit("fill_hole", {1, 2}, {}, {});

  EXPECT_EQ(code_of(refused), ec::superseded);
  EXPECT_FALSE(refused.error().remedy.empty());
  cancel.cancel();
  EXPECT_EQ(edit.get().error().code, ec::cancelled);
}

TEST_F(Preview, TheEndOfTheConnectionEndsIt) {
  begin(true);
  auto third = connect(host->url());
  value(third->open("plate", false, false));
  auto held = hold(*third, {});

  third->abort();

  EXPECT_EQ(code_of(held.get()), ec::service_unavailable);
  const auto busy = [&] {
    for (const auto& worker : value(user->status()).workers)
      if (worker.jobs > 0)
        return true;
    return false;
  };
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (busy() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(busy());
  expect_untouched();
}

TEST_F(Preview, ACrashInItIsToldAndDoesNotCountForTheQuarantine) {
  begin(true, "every_surface_alone");

  for (int preview = 0; preview < 4; ++preview) {
    const auto crashed = user->preview_edit("rule_breaker", {1}, {}, {});
    ASSERT_FALSE(crashed.has_value());
    EXPECT_EQ(crashed.error().code, ec::internal);
    EXPECT_THAT(crashed.error().message, HasSubstr("signal 11"));
  }
  EXPECT_EQ(user->edit("rule_breaker", {1}, {}, {}).error().code, ec::internal);
}

TEST_F(Preview, OfManyAtOnceTheNewestIsAnsweredAndNoneIsLost) {
  begin(true);
  std::vector<std::future<expected<client::edit_preview>>> asked;
  for (int i = 0; i < 8; ++i)
    asked.push_back(std::async(std::launch::async, [this] { return look({1, 2}); }));

  int made = 0;
  for (auto& one : asked) {
    const auto got = one.get();
    made += got.has_value();
    EXPECT_TRUE(got || got.error().code == ec::superseded);
  }
  EXPECT_GE(made, 1);
  expect_untouched();
}

}  // namespace
}  // namespace tedit::test
