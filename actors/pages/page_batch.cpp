// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/pages/page_batch.hpp"

#include <zstd.h>

namespace tedit::actors {

namespace {

constexpr std::size_t pages_per_batch = max_batch_bytes / max_page_bytes;

/// Bytes of what most pages hold: doubles, pairs of 32-bit numbers.
constexpr std::size_t stride = 8;

constexpr int zstd_level = 1;

/// Bytes as a table of so many columns, column by column; what is left over stays at the end. With
/// `stride` columns all first bytes of numbers stand together, then all second ones, as high bytes
/// of neighbours are alike; with as many columns as there are numbers they are put together again.
std::vector<char> transposed(const std::vector<char>& bytes, std::size_t columns) {
  const auto numbers = bytes.size() / stride;
  const auto rows = columns == 0 ? 0 : numbers * stride / columns;
  auto result = bytes;
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t r = 0; r < rows; ++r)
      result[c * rows + r] = bytes[r * columns + c];
  return result;
}

void make_small(page_batch& batch) {
  const auto apart = transposed(batch.bytes, stride);
  std::vector<char> small(ZSTD_compressBound(apart.size()));
  const auto size =
    ZSTD_compress(small.data(), small.size(), apart.data(), apart.size(), zstd_level);
  if (ZSTD_isError(size) || 10 * size > 9 * batch.bytes.size())
    return;
  small.resize(size);
  batch.bytes = std::move(small);
  batch.packed = true;
}

/// The bytes of all pages of a batch, `whole` of them.
expected<std::vector<char>> make_whole(const page_batch& batch, std::size_t whole) {
  std::vector<char> apart(whole);
  const auto size =
    ZSTD_decompress(apart.data(), apart.size(), batch.bytes.data(), batch.bytes.size());
  if (ZSTD_isError(size) || size != whole)
    return fail(ec::protocol_error, "a node sent a batch of pages that cannot be unpacked");
  return transposed(apart, whole / stride);
}

/// Bytes of all pages. Errors: `protocol_error` for sizes that no batch has.
expected<std::size_t> checked_size(const page_batch& batch) {
  std::size_t whole = 0;
  for (const auto size : batch.sizes) {
    if (size > max_page_bytes)
      return fail(ec::protocol_error, "a node sent a page of a wrong size");
    whole += size;
  }
  if (whole > max_batch_bytes || (!batch.packed && whole != batch.bytes.size()))
    return fail(ec::protocol_error, "a node sent a batch of pages of a wrong size");
  return whole;
}

}  // namespace

std::deque<hash_list> split(const hash_list& ids) {
  std::deque<hash_list> batches;
  for (std::size_t first = 0; first < ids.size(); first += pages_per_batch) {
    const auto last = std::min(ids.size(), first + pages_per_batch);
    batches.emplace_back(ids.begin() + static_cast<std::ptrdiff_t>(first),
                         ids.begin() + static_cast<std::ptrdiff_t>(last));
  }
  return batches;
}

expected<page_batch> pack(page_cache& cache, const hash_list& ids, bool packed) {
  if (ids.size() > pages_per_batch)
    return fail(ec::invalid_argument, "more pages are asked for than a batch may hold");
  page_batch batch;
  for (const auto& id : ids) {
    const auto p = cache.find(id);
    if (!p)
      return fail(ec::not_found, "page " + to_hex(id) + " is not here any more");
    const auto bytes = p->bytes();
    const auto* first = reinterpret_cast<const char*>(bytes.data());
    batch.sizes.push_back(static_cast<std::uint32_t>(bytes.size()));
    batch.bytes.insert(batch.bytes.end(), first, first + bytes.size());
  }
  if (packed)
    make_small(batch);
  return batch;
}

expected<std::vector<page_ptr>> unpack(const page_batch& batch, const hash_list& ids) {
  if (batch.sizes.size() != ids.size())
    return fail(ec::protocol_error, "a node sent another number of pages than asked for");
  const auto whole = checked_size(batch);
  if (!whole)
    return fail(whole.error());
  std::vector<char> unpacked;
  if (batch.packed) {
    auto made = make_whole(batch, *whole);
    if (!made)
      return fail(made.error());
    unpacked = std::move(*made);
  }
  const auto& bytes = batch.packed ? unpacked : batch.bytes;
  std::vector<page_ptr> pages;
  std::size_t offset = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    auto p = page::from_bytes(std::as_bytes(std::span(bytes.data() + offset, batch.sizes[i])));
    if (p->id() != ids[i])
      return fail(ec::protocol_error, "page " + to_hex(ids[i]) + " was damaged on its way");
    pages.push_back(std::move(p));
    offset += batch.sizes[i];
  }
  return pages;
}

}  // namespace tedit::actors
