// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fstream>

#include "actors/gateway/token_guard.hpp"
#include "actors/gateway/users.hpp"
#include "base/logging/logging.hpp"
#include "tests/fuzz/promise.hpp"
#include "tests/support/scratch.hpp"

namespace {

using namespace tedit;
namespace fs = std::filesystem;

/// The file of two users, some of whose bytes are overwritten: three bytes say where, one with
/// what. One that is made up from nothing is refused by its first bytes.
struct damaged_users {
  explicit damaged_users(std::span<const std::uint8_t> bytes) {
    logging::set_level("off");
    auto text = sound();
    fuzz::input in(bytes);
    for (int i = 0; i < 128 && !in.at_end(); ++i) {
      const auto at = static_cast<std::size_t>(in.number(3) % text.size());
      text[at] = static_cast<char>(in.number(1));
    }
    std::ofstream(file(), std::ios::binary) << text;
    fs::permissions(file(), fs::perms::owner_read | fs::perms::owner_write);
  }
  [[nodiscard]] fs::path file() const { return folder.path() / "users.sqlite"; }

  /// The bytes of a file with two users and three tokens; made once.
  static const std::string& sound() {
    static const std::string made = [] {
      const test::scratch_folder at;
      const auto name = at.path() / "users.sqlite";
      {
        auto users = test::value(gateway::user_file::open(name));
        test::value(users.add("anna", gateway::access_role::admin, std::nullopt));
        test::value(users.add("bea@example.org", gateway::access_role::view, 4'000'000'000));
        test::value(users.add_token("anna", 1));
      }
      std::ifstream in(name, std::ios::binary);
      return std::string((std::istreambuf_iterator<char>(in)), {});
    }();
    return made;
  }

  test::scratch_folder folder;
};

void check_keeper(const fs::path& file) {
  auto users = gateway::user_file::open(file);
  if (!users)
    return fuzz::require_reason(users.error());
  const auto all = users->list();
  if (!all)
    return fuzz::require_reason(all.error());
  for (const auto& one : *all)
    fuzz::require(!gateway::name_of(one.role).empty(), "a listed user has a role that there is");
}

}  // namespace

/// The bytes damage the file of the users, and are a token that somebody shows. Nobody is let in
/// whose token is not in the file; that of the server always is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const damaged_users users({data, size});
  const std::string shown(reinterpret_cast<const char*>(data), size);
  if (auto book = gateway::user_book::open(users.file())) {
    const gateway::token_guard guard("the server's own", *book);
    fuzz::require(!guard.admits(shown), "who knows no token is not let in");
    fuzz::require(guard.admits(std::string("the server's own")).has_value(),
                  "the server's own token lets in");
    for (std::int64_t number = -1; number < 5; ++number)
      if (const auto who = guard.admits(number))
        fuzz::require(!gateway::name_of(who->role).empty(), "who is let in has a role");
  } else {
    fuzz::require_reason(book.error());
  }
  check_keeper(users.file());
  return 0;
}
