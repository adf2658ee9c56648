// SPDX-License-Identifier: AGPL-3.0-or-later
// What guards a document's rows against damage and careless edits (docs/decisions/0018).
#pragma once

#include <string>
#include <vector>

#include "actors/store/sql.hpp"

namespace tedit::store {

/// The tables whose rows have a hash beside them; pages have their own, their identity.
enum class table { version, head, log, annotation, cad };

inline constexpr int sealed_tables = 5;
/// Of the format before there were CAD models: the first ones.
inline constexpr int sealed_tables_of_format_2 = 4;

/// What stands for all rows of a document together: how many there are, the sum of their hashes
/// modulo 2^128, and the hash of the database's schema. Its cost follows the changed rows, not
/// their number: a new row adds its hash, a changed one takes its old hash off and adds the new.
struct seal {
  std::int64_t rows = 0;
  hash128 sum;
  hash128 schema;

  void add(const hash128& row) noexcept;
  void take_off(const hash128& row) noexcept;

  friend bool operator==(const seal&, const seal&) = default;
};

/// The statements that read, check and write hashes and the seal of one open database.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): the compiler's.
class seal_keeper {
public:
  /// @param tables the first so many there are. Errors: those of `sql_failure`.
  [[nodiscard]] expected<void> prepare_all(sqlite3* db, int tables = sealed_tables);

  /// Whether the document is of a format that has this table.
  [[nodiscard]] bool has(table of) const { return static_cast<int>(of) < tables_; }

  /// The seal as it is stored. Errors: `storage_error` when there is none.
  [[nodiscard]] expected<seal> stored() const;

  /// Reads every row of `of`, checks its hash, adds it to `sum`, and hands the row on; columns as
  /// in `columns_of`. `damage` is told of each row that is damaged, by a `storage_error` that names
  /// it: what it returns ends the reading, or the row is left out.
  template <class Use, class Damage>
  [[nodiscard]] expected<void> read_all(table of, seal& sum, Use use, const Damage& damage) const {
    query rows(all_[static_cast<int>(of)]);
    expected<bool> more;
    while ((more = rows.next()) && *more) {
      if (auto ok = check(of, rows, sum); ok)
        use(rows);
      else if (auto go_on = damage(ok.error()); !go_on)
        return fail(go_on.error());
    }
    return more.map([](bool) {});
  }

  /// What all rows together must be. Errors: `storage_error` saying what is missing.
  [[nodiscard]] expected<void> compare(const seal& found) const;

  /// Carries out `write`, which changes or makes the one row of `of` with this key, and brings its
  /// hash and `sum` up to date. Errors: those of `write`; `storage_error` when the row was damaged
  /// before.
  template <class Write>
  [[nodiscard]] expected<void> change(table of, std::int64_t key, seal& sum, Write write) const {
    const auto before = hash_of(of, key);
    if (!before)
      return fail(before.error());
    if (auto done = write(); !done)
      return done;
    return put_hash(of, key, *before, sum);
  }

  /// Gives a row that was just inserted its hash and adds it to `sum`. Errors: those of
  /// `sql_failure`.
  [[nodiscard]] expected<void> added(table of, std::int64_t key, seal& sum) const {
    return put_hash(of, key, std::nullopt, sum);
  }

  /// Stores the seal. Errors: those of `sql_failure`.
  [[nodiscard]] expected<void> store(const seal& value) const;

  /// The hash of the schema as it is now. Errors: those of `sql_failure`.
  [[nodiscard]] expected<hash128> schema_hash() const;

  /// Gives every row its hash and the document its seal, whatever stood there before: for new
  /// documents and those from before there were hashes. Errors: those of `sql_failure`.
  [[nodiscard]] expected<void> seal_everything() const;

private:
  expected<void> check(table of, query& row, seal& sum) const;
  expected<std::optional<hash128>> hash_of(table of, std::int64_t key) const;
  expected<void> put_hash(table of, std::int64_t key, const std::optional<hash128>& before,
                          seal& sum) const;

  statement all_[sealed_tables], one_[sealed_tables], set_hash_[sealed_tables];
  statement read_seal_, write_seal_, schema_;
  int tables_ = 0;
};

}  // namespace tedit::store
