// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/seal.hpp"

#include <cstring>
#include <span>

namespace tedit::store {

namespace {

/// A sealed table: its key, and its columns without the hash; the key comes first.
struct shape {
  table of;
  const char* name;
  const char* key;
  const char* columns;
  int count;
};

constexpr shape shapes[sealed_tables] = {
  {table::version, "version", "number",
   "number, parent, id, manifest, operation, load_cases, report, redo", 8},
  {table::head, "head", "one", "one, version", 2},
  {table::log, "log", "sequence", "sequence, what, details", 3},
  {table::annotation, "annotation", "version", "version, name, note", 3},
  {table::cad, "cad", "version", "version, status, reason, deviation, facts, shape", 6},
};

const shape& shape_of(table of) {
  return shapes[static_cast<int>(of)];
}

std::string name_of(table of, std::int64_t key) {
  const auto number = std::to_string(key);
  switch (of) {
    case table::version:
      return "version " + number;
    case table::head:
      return "the mark of the current version";
    case table::log:
      return "line " + number + " of the log";
    case table::annotation:
      return "the name and note of version " + number;
    case table::cad:
      return "the CAD model of version " + number;
  }
  return {};
}

tl::unexpected<error> seal_broken(const std::string& what) {
  return fail(ec::storage_error,
              "the document is damaged or was changed by another program: " + what,
              "Restore the document from a backup");
}

void append(std::vector<std::byte>& to, const void* start, std::size_t size) {
  const auto* first = static_cast<const std::byte*>(start);
  to.insert(to.end(), first, first + size);
}

/// The hash of a row's first columns: of the name of its table, and of each value's type, length
/// and bytes, so that no two different rows are the same text.
hash128 hash_row(std::string_view name, sqlite3_stmt* row, int columns) {
  std::vector<std::byte> text;
  append(text, name.data(), name.size() + 1);  // names are literals: a zero ends them
  for (int i = 0; i < columns; ++i) {
    const auto type = static_cast<char>(sqlite3_column_type(row, i));
    const void* start = type == SQLITE_BLOB ? sqlite3_column_blob(row, i)
                                            : static_cast<const void*>(sqlite3_column_text(row, i));
    const auto size = static_cast<std::uint64_t>(sqlite3_column_bytes(row, i));
    append(text, &type, sizeof type);
    append(text, &size, sizeof size);
    if (size > 0)
      append(text, start, size);
  }
  return hash_bytes(text);
}

}  // namespace

void seal::add(const hash128& row) noexcept {
  ++rows;
  sum.low += row.low;
  sum.high += row.high + (sum.low < row.low ? 1 : 0);
}

void seal::take_off(const hash128& row) noexcept {
  --rows;
  sum.high -= row.high + (sum.low < row.low ? 1 : 0);
  sum.low -= row.low;
}

expected<void> seal_keeper::prepare_all(sqlite3* db, int tables) {
  tables_ = tables;
  std::vector<std::pair<statement*, std::string>> wanted{
    {&read_seal_, "SELECT rows, sum, schema FROM seal"},
    {&write_seal_, "INSERT OR REPLACE INTO seal(one, rows, sum, schema) VALUES(1, ?, ?, ?)"},
    {&schema_, "SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY type, name"}};
  for (const auto& t : std::span(shapes).first(static_cast<std::size_t>(tables))) {
    const int i = static_cast<int>(t.of);
    const std::string key = t.key;
    const auto select = std::string("SELECT ") + t.columns + ", hash FROM " + t.name;
    wanted.emplace_back(&all_[i], select + " ORDER BY " + key);
    wanted.emplace_back(&one_[i], select + " WHERE " + key + " = ?");
    wanted.emplace_back(&set_hash_[i],
                        std::string("UPDATE ") + t.name + " SET hash = ?2 WHERE " + key + " = ?1");
  }
  for (auto& [into, sql] : wanted) {
    auto made = prepare(db, sql);
    if (!made)
      return fail(made.error());
    *into = std::move(*made);
  }
  return {};
}

expected<seal> seal_keeper::stored() const {
  query row(read_seal_);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  const seal value{row.number(0), row.hash(1), row.hash(2)};
  if (!*found || !row.sound())
    return seal_broken("its seal is not there");
  return value;
}

expected<void> seal_keeper::check(table of, query& row, seal& sum) const {
  const auto& t = shape_of(of);
  const auto hash = hash_row(t.name, row.row(), t.count);
  if (row.text(t.count) != to_hex(hash))
    return seal_broken(name_of(of, row.number(0)));
  sum.add(hash);
  return {};
}

expected<void> seal_keeper::compare(const seal& found) const {
  const auto wanted = stored();
  if (!wanted)
    return fail(wanted.error());
  if (found.schema != wanted->schema)
    return seal_broken("its tables are not those that TEdit made");
  if (found.rows != wanted->rows)
    return seal_broken("it has " + std::to_string(found.rows) + " rows where " +
                       std::to_string(wanted->rows) + " belong");
  if (found.sum != wanted->sum)
    return seal_broken("some of its rows are from another state of it, or its seal is wrong");
  return {};
}

expected<std::optional<hash128>> seal_keeper::hash_of(table of, std::int64_t key) const {
  query row(one_[static_cast<int>(of)], key);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  if (!*found)
    return std::nullopt;
  seal scratch;
  if (auto ok = check(of, row, scratch); !ok)
    return fail(ok.error());
  return scratch.sum;
}

expected<void> seal_keeper::put_hash(table of, std::int64_t key,
                                     const std::optional<hash128>& before, seal& sum) const {
  const auto& t = shape_of(of);
  hash128 hash;
  {
    query row(one_[static_cast<int>(of)], key);
    const auto found = row.next();
    if (!found)
      return fail(found.error());
    if (!*found)  // Nothing was changed; who writes complains.
      return {};
    hash = hash_row(t.name, row.row(), t.count);
  }
  if (before)
    sum.take_off(*before);
  sum.add(hash);
  return query(set_hash_[static_cast<int>(of)], key, hash).run();
}

expected<void> seal_keeper::store(const seal& value) const {
  return query(write_seal_, value.rows, value.sum, value.schema).run();
}

expected<hash128> seal_keeper::schema_hash() const {
  query rows(schema_);
  seal sum;
  expected<bool> more;
  while ((more = rows.next()) && *more)
    sum.add(hash_row("schema", rows.row(), 4));
  if (!more)
    return fail(more.error());
  return sum.sum;
}

expected<void> seal_keeper::seal_everything() const {
  seal sum;
  for (const auto& t : shapes) {
    std::vector<std::int64_t> keys;
    {
      query rows(all_[static_cast<int>(t.of)]);
      expected<bool> more;
      while ((more = rows.next()) && *more)
        keys.push_back(rows.number(0));
      if (!more)
        return fail(more.error());
    }
    for (const auto key : keys)
      if (auto done = put_hash(t.of, key, std::nullopt, sum); !done)
        return done;
  }
  const auto schema = schema_hash();
  if (!schema)
    return fail(schema.error());
  sum.schema = *schema;
  return store(sum);
}

}  // namespace tedit::store
