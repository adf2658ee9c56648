// SPDX-License-Identifier: AGPL-3.0-or-later
// Who watches and does not keep up is spared what has become old; nobody waits for it.
#include <atomic>

#include "tests/scenarios/fixture.hpp"
#include "tests/support/slow_proxy.hpp"

namespace tedit::test {
namespace {

constexpr int toggles = 60;
const auto* const last_mesh = TEDIT_TEST_DATA "/parts/inch_block/inch_block.coarse.msh";

std::uint16_t port_in(const std::string& url) {
  const auto colon = url.rfind(':');
  return static_cast<std::uint16_t>(std::stoi(url.substr(colon + 1)));
}

std::string through(const slow_proxy& line, const std::string& url) {
  const auto colon = url.rfind(':');
  return url.substr(0, colon + 1) + std::to_string(line.port()) + url.substr(url.find('/', colon));
}

// Undo and redo go between two different parts, so that each step is a whole surface.
TEST(SlowWatcher, GetsEveryHeadButNotEverySurface) {
  const scratch_folder folder;
  const auto host = start(options_for(folder, false));
  const auto editor = connect(host->url());
  value(editor->open("part", false, false));
  value(editor->import_file(plate_mesh, "mm", {}));
  value(editor->import_file(TEDIT_TEST_DATA "/parts/fork_thin/fork_thin.coarse.msh", "mm", {}));

  slow_proxy line(port_in(host->url()), {std::chrono::milliseconds(0), 1U << 30});
  std::atomic<int> heads = 0;
  std::atomic<int> surfaces = 0;
  client::events events;
  events.on_committed = [&](const auto&) { ++heads; };
  events.on_surface = [&](const auto&) { ++surfaces; };
  const auto watcher = connect(through(line, host->url()), std::move(events));
  const auto state = value(watcher->open("part", true, false));
  value(watcher->wait_surface(state.head->version_id, patience));
  const auto first = surfaces.load();
  const auto witness = connect(host->url());
  value(witness->open("part", true, false));
  line.stall(true);

  for (int i = 0; i < toggles; ++i)
    value(i % 2 == 0 ? editor->undo() : editor->redo());
  const auto last = value(editor->import_file(last_mesh, "mm", {}));
  // On a busy machine the server tells watchers later than it answers: not while the line stands.
  value(witness->wait_surface(last.head.version_id, patience));

  line.stall(false);
  value(watcher->wait_surface(last.head.version_id, patience));  // Which nobody saw before.
  const auto fresh = connect(host->url());
  value(fresh->open("part", true, false));
  value(fresh->wait_surface(last.head.version_id, patience));
  expect_same(watcher->surface(), fresh->surface());
  EXPECT_EQ(heads, toggles + 1);  // Events go before surfaces, so all have come.
  EXPECT_GE(surfaces - first, 1);
  EXPECT_LT(surfaces - first, toggles / 2);
}

}  // namespace
}  // namespace tedit::test
