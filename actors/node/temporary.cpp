// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents to which nobody gave a name: they go some time after their last client
// (docs/decisions/0035).
#include <chrono>

#include "actors/node/hub_work.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

namespace {

/// It goes after a while, unless somebody opens it before and leaves it later.
void expect_end(hub_pointer self, const std::string& name) {
  auto& state = self->state;
  const auto number = ++state.temporaries;
  state.temporary[name] = number;
  self->delayed_send(self, state.parts.temporary_limit, rest_atom::value, name, number);
}

}  // namespace

std::string make_temporary_name(hub_state& state) {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return temporary_prefix + std::to_string(now) + "-" + std::to_string(++state.temporaries);
}

expected<void> check_lasting_name(const std::string& name) {
  if (auto ok = check_document_name(name); !ok)
    return ok;
  if (is_temporary(name))
    return fail(ec::invalid_argument,
                "\"" + name + "\" is a name for documents that go after their last client",
                "Take another name: with one of your own a document stays");
  return {};
}

error ended_document(const std::string& name) {
  return {ec::not_found,
          "the document " + name + " is gone: it had no name of its own, and no client had it open",
          "Open a new one, and give it a name of its own to keep it",
          {}};
}

void note_left(hub_pointer self, const std::string& name) {
  if (is_temporary(name) && has_file(self->state, name))
    expect_end(self, name);
}

/// Of a server that was stopped or killed: their clients have the same time to come back.
void expect_ends(hub_pointer self) {
  ask_disk(self, folder_query{self->state.parts.documents})
    .then(
      [=](const document_list& files) {
        for (const auto& row : files.documents)
          if (is_temporary(row.name) && !self->state.open.contains(row.name))
            expect_end(self, row.name);
      },
      [=](const caf::error& e) {
        logging::warn("{}", render(from_caf(e, "looking for documents without a name")));
      });
}

void end_temporary(hub_pointer self, const std::string& name, std::uint64_t number) {
  auto& state = self->state;
  const auto expected_end = state.temporary.find(name);
  if (expected_end == state.temporary.end() || expected_end->second != number)
    return;
  state.temporary.erase(expected_end);
  if (is_busy(state, name) || state.open.contains(name) || !has_file(state, name))
    return;  // Whoever has it now will leave it.
  state.opening[name];
  ask_disk(self, deletion{file_of(state, name)})
    .then(
      [=](acknowledged) {
        logging::info("{}: gone, it had no name of its own and no client", name);
        take_deleted(self->state, name);
        let_go(self, name);
      },
      [=](const caf::error& e) {
        logging::warn("{}: stays, {}", name, render(from_caf(e, "deleting it")));
        let_go(self, name);
      });
}

}  // namespace tedit::actors
