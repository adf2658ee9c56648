// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actors/store/sql.hpp"
#include "base/error.hpp"
#include "base/file_stamp.hpp"

/// Who may use a server beside those who have its own token: people with tokens that end and can be
/// withdrawn, in a file (SQLite) for the server's owner alone. A token is 256 random bits; the file
/// has its SHA-256, from which nobody finds it (docs/decisions/0040).
namespace tedit::gateway {

/// What somebody may do, each also what those before it may; `least_role` has it by request.
enum class access_role { view, edit, admin };

struct access_role_row {
  access_role value;
  std::string_view name;
};

inline constexpr std::array access_roles{access_role_row{access_role::view, "view"},
                                         access_role_row{access_role::edit, "edit"},
                                         access_role_row{access_role::admin, "admin"}};

[[nodiscard]] std::string_view name_of(access_role role);
[[nodiscard]] std::optional<access_role> access_role_named(std::string_view name);

/// Whom a token lets in.
struct grant {
  std::string user;  ///< Empty: who has the server's own token.
  access_role role = access_role::admin;
  std::int64_t token = 0;             ///< Its number; 0: the server's own.
  std::optional<std::int64_t> until;  ///< When it ends, seconds since 1970; none: never.

  [[nodiscard]] bool has_ended(std::int64_t now) const { return until && *until <= now; }

  friend bool operator==(const grant&, const grant&) = default;
};

struct listed_token {
  std::int64_t number = 0;
  std::int64_t made = 0;              ///< Seconds since 1970, as is `until`.
  std::optional<std::int64_t> until;  ///< None: never.
};

struct listed_user {
  std::string name;
  access_role role = access_role::view;
  std::vector<listed_token> tokens;  ///< By number.
};

struct new_token {
  std::string text;  ///< To be given to the user; it is nowhere else.
  std::int64_t number = 0;
};

/// The file, as who keeps it uses it. Every change is durable when it returns; a server that uses
/// the file heeds it within a minute.
/// Errors of all: `storage_error`, `conflict` while another program changes it, `io_error`.
class user_file {
public:
  /// Makes the file when it is not there. Errors: also `bad_input` for a file that is none,
  /// `invalid_argument` when others may read it.
  [[nodiscard]] static expected<user_file> open(const std::filesystem::path& file);

  /// A new user with a first token. Errors: also `conflict` for a name that is taken,
  /// `invalid_argument` for one that cannot be: up to 63 letters, digits, ".", "-", "_" and "@".
  [[nodiscard]] expected<new_token> add(const std::string& name, access_role role,
                                        std::optional<std::int64_t> until);
  /// One more token. Errors: also `not_found`.
  [[nodiscard]] expected<new_token> add_token(const std::string& name,
                                              std::optional<std::int64_t> until);
  /// Errors: also `not_found`.
  [[nodiscard]] expected<void> set_role(const std::string& name, access_role role);
  /// Ends a token. Errors: also `not_found`.
  [[nodiscard]] expected<void> withdraw(std::int64_t number);
  /// Ends all tokens of a user, who is forgotten. Errors: also `not_found`.
  [[nodiscard]] expected<void> remove(const std::string& name);
  /// By name.
  [[nodiscard]] expected<std::vector<listed_user>> list();

private:
  user_file(std::filesystem::path file, store::connection db)
      : file_(std::move(file)), db_(std::move(db)) {}

  [[nodiscard]] tl::unexpected<error> failure() const;
  [[nodiscard]] expected<void> begin();
  [[nodiscard]] expected<void> commit();
  template <class... Values>
  [[nodiscard]] expected<int> change(const char* sql, const Values&... values);
  [[nodiscard]] expected<new_token> insert_token(const std::string& name,
                                                 std::optional<std::int64_t> until);

  std::filesystem::path file_;
  store::connection db_;
};

/// The file, as a server uses it: changes of others are seen at the next look. Thread-safe; no call
/// waits for who changes the file.
class user_book {
public:
  /// The file need not be there, and may come later. Errors: those of `user_file::open`.
  [[nodiscard]] static expected<std::shared_ptr<user_book>> open(std::filesystem::path file);

  /// Whom a token lets in, also one that has ended. What cannot be read now leaves what was read
  /// before in force, and is logged.
  [[nodiscard]] std::optional<grant> find(const std::string& token);
  /// The same by the token's number; none when it was withdrawn.
  [[nodiscard]] std::optional<grant> find(std::int64_t number);

private:
  using hash_text = std::string;

  explicit user_book(std::filesystem::path file) : file_(std::move(file)) {}
  [[nodiscard]] expected<void> look();
  [[nodiscard]] expected<void> read();
  void look_and_say();

  const std::filesystem::path file_;
  std::mutex mutex_;  ///< Guards what follows.
  file_stamp seen_{};
  store::connection db_;
  std::int64_t version_ = -1;  ///< SQLite's number of what others changed.
  std::map<hash_text, grant> grants_;
  bool said_ = false;  ///< That it cannot be read.
};

/// Seconds since 1970.
[[nodiscard]] std::int64_t seconds_now();

}  // namespace tedit::gateway
