// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/reading.hpp"

#include <zstd.h>

#include <algorithm>

#include "actors/store/schema.hpp"

namespace tedit::store {

namespace {

tl::unexpected<error> broken(std::string what) {
  return fail(ec::storage_error, std::move(what), "Restore the document from a backup");
}

/// What takes each damage: an error ends the reading.
using complaint = std::function<expected<void>(const error&)>;

/// Reads the rows of one open database.
struct row_reader {
  sqlite3* db;
  const seal_keeper& seals;
  contents all;
  seal sum;
  bool fitting = true;  ///< All numbers so far had their shape.

  void take_version(query& row) {
    all.versions.push_back({row.u32(0).value_or(0), row.u32(1), row.hash(2), row.blob(3),
                            row.text(4), row.text(5), row.text(6), row.u32(7), "", ""});
    fitting = fitting && row.sound();
  }

  /// A name of a version that is not there says nothing.
  void take_annotation(query& row) {
    const auto number = row.u32(0).value_or(0);
    const auto of = std::ranges::lower_bound(all.versions, number, {}, &version_row::number);
    if (of == all.versions.end() || of->number != number) {
      fitting = false;
      return;
    }
    of->name = row.text(1);
    of->note = row.text(2);
  }

  void take_cad(query& row) {
    all.cad.push_back({row.u32(0).value_or(0), row.text(1), row.text(2), row.real(3), "", ""});
  }

  expected<void> read(const complaint& damage) {
    const auto version = [&](query& row) { take_version(row); };
    const auto head = [&](query& row) { all.head = row.u32(1); };
    const auto log = [&](query& row) {
      all.log.push_back({static_cast<std::uint64_t>(row.number(0)), row.text(1), row.text(2)});
    };
    const auto annotation = [&](query& row) { take_annotation(row); };
    return seals.read_all(table::version, sum, version, damage)
      .and_then([&] { return seals.read_all(table::head, sum, head, damage); })
      .and_then([&] { return seals.read_all(table::log, sum, log, damage); })
      .and_then([&] { return seals.read_all(table::annotation, sum, annotation, damage); })
      .and_then([&] {
        return seals.has(table::cad)
                 ? seals.read_all(
                     table::cad, sum, [&](query& row) { take_cad(row); }, damage)
                 : expected<void>();
      });
  }

  /// What hashes do not tell: whether numbers fit, and the log's next one, which SQLite keeps.
  [[nodiscard]] expected<void> check_numbers() const {
    const auto last_used = number_of(db, "SELECT coalesce(max(seq), 0) FROM sqlite_sequence");
    if (!last_used)
      return fail(last_used.error());
    if (*last_used != (all.log.empty() ? 0 : static_cast<std::int64_t>(all.log.back().sequence)))
      return broken("the document is damaged: the numbers of the log were changed");
    if (!fitting)
      return broken("the document has a version with impossible numbers");
    return {};
  }
};

}  // namespace

expected<contents> read_contents(sqlite3* db, const seal_keeper& seals) {
  row_reader reader{db, seals, {}, {}};
  return check_structure(db)
    .and_then([&] { return seals.schema_hash(); })
    .and_then([&](const hash128& schema) {
      reader.sum.schema = schema;
      return reader.read([](const error& e) { return fail(e); });
    })
    .and_then([&] { return seals.compare(reader.sum); })
    .and_then([&] { return reader.check_numbers(); })
    .map([&] { return std::move(reader.all); });
}

expected<sound_rows> read_sound_rows(sqlite3* db, const seal_keeper& seals) {
  sound_rows result;
  const auto note = [&](const error& e) -> expected<void> {
    result.damage.push_back(e);
    return {};
  };
  row_reader reader{db, seals, {}, {}};
  if (auto sound = check_structure(db); !sound)
    result.damage.push_back(sound.error());
  const auto schema = seals.schema_hash();
  if (!schema)
    return fail(schema.error());
  reader.sum.schema = *schema;
  if (auto done = reader.read(note); !done)
    return fail(done.error());
  // What a damaged row says is not in the sum: then the seal says nothing that is not known.
  if (auto whole = seals.compare(reader.sum); !whole && result.damage.empty())
    result.damage.push_back(whole.error());
  if (auto fits = reader.check_numbers(); !fits && result.damage.empty())
    result.damage.push_back(fits.error());
  result.rows = std::move(reader.all);
  return result;
}

expected<page_ptr> find_page(const statement& by_id, const hash128& id) {
  query row(by_id, id);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  if (!*found)
    return fail(ec::not_found, "page " + to_hex(id) + " is not in the document",
                "Restore the document from a backup");
  const auto size = row.number(0);
  if (size < 0 || size > std::int64_t{max_page_bytes})
    return broken("page " + to_hex(id) + " claims " + std::to_string(size) + " bytes");
  auto result = std::make_shared<page>(static_cast<std::size_t>(size));
  const auto packed = row.blob(1);
  const auto written = ZSTD_decompress(result->mutable_bytes().data(), result->bytes().size(),
                                       packed.data(), packed.size());
  if (ZSTD_isError(written) || written != result->bytes().size() || result->id() != id)
    return broken("page " + to_hex(id) + " is damaged");
  return result;
}

expected<std::optional<cad_row>> find_cad(const statement& by_number, std::uint32_t number) {
  query row(by_number, number);
  const auto found = row.next();
  if (!found)
    return fail(found.error());
  if (!*found)
    return std::nullopt;
  cad_row result{number, row.text(1), row.text(2), row.real(3), row.text(4), ""};
  const auto packed = row.blob(5);
  constexpr unsigned long long most = 1ULL << 30;
  const auto size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size > most)  // Also what it says for bytes that are none of its own.
    return broken("the CAD model of version " + std::to_string(number) + " is damaged");
  result.shape.resize(size);
  const auto written = ZSTD_decompress(result.shape.data(), size, packed.data(), packed.size());
  if (ZSTD_isError(written) || written != size)
    return broken("the CAD model of version " + std::to_string(number) + " is damaged");
  return result;
}

}  // namespace tedit::store
