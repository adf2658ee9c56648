// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/versions.hpp"

#include "fem/quantities.hpp"

namespace tedit::actors {

version_ref make_ref(const version_ptr& version) {
  return {version->id(), {version, &version->pages()}};
}

double tets_of(const version_ref& ref) {
  constexpr std::size_t tet_array = 2;  // As `mesh_data` has them.
  const bool known = ref.pages && ref.pages->arrays.size() > tet_array;
  return known ? static_cast<double>(ref.pages->arrays[tet_array].size) : 0;
}

expected<hash_list> pages_of(const version_ref& ref) {
  if (!ref.pages)
    return fail(ec::protocol_error, "a version's manifest was damaged on its way");
  return ref.pages->page_ids();
}

expected<version_ptr> open_version(const version_ref& ref, const page_set& pages) {
  if (!ref.pages)
    return fail(ec::protocol_error, "a version's manifest was damaged on its way");
  return mesh_version::from_manifest(*ref.pages, [&](const hash128& id) { return pages.find(id); });
}

field_ref make_ref(const field& f) {
  field_ref ref{f.name, f.location == field_location::vertex, f.components, f.values.size(), {}};
  for (const auto& p : f.values.pages())
    ref.pages.push_back(p->id());
  return ref;
}

const fem::result_array* for_watchers(const field_ref& one) {
  for (const auto& array : fem::result_arrays)
    if (fem::is_for_watchers(array) && one.name.starts_with(array.name) &&
        (one.name.size() == array.name.size() || one.name[array.name.size()] == ' '))
      return &array;
  return nullptr;
}

hash_list pages_of(const std::vector<field_ref>& fields) {
  hash_list ids;
  for (const auto& f : fields)
    ids.insert(ids.end(), f.pages.begin(), f.pages.end());
  return ids;
}

expected<field> open_field(const field_ref& ref, const page_set& pages) {
  std::vector<page_ptr> list;
  for (const auto& id : ref.pages) {
    list.push_back(pages.find(id));
    if (!list.back())
      return fail(ec::not_found, "a page of the field " + ref.name + " is missing");
  }
  auto values = paged_array<double>::from_pages(std::move(list), ref.size);
  if (!values)
    return fail(values.error());
  return field{ref.name, ref.on_vertices ? field_location::vertex : field_location::tet,
               ref.components, std::move(*values)};
}

std::vector<page_ptr> cut(std::span<const char> bytes) {
  std::vector<page_ptr> pages;
  for (std::size_t first = 0; first < bytes.size(); first += max_page_bytes)
    pages.push_back(page::from_bytes(
      std::as_bytes(bytes.subspan(first, std::min(max_page_bytes, bytes.size() - first)))));
  return pages;
}

expected<std::vector<char>> join(const hash_list& ids, std::uint64_t size, const page_set& pages) {
  std::vector<char> bytes;
  for (const auto& id : ids) {
    const auto p = pages.find(id);
    if (!p)
      return fail(ec::not_found, "a piece of the file is missing");
    const auto part = p->bytes();
    const auto* first = reinterpret_cast<const char*>(part.data());
    bytes.insert(bytes.end(), first, first + part.size());
  }
  if (bytes.size() != size)
    return fail(ec::protocol_error, "the file has " + std::to_string(bytes.size()) +
                                      " bytes, not " + std::to_string(size) + " as announced");
  return bytes;
}

}  // namespace tedit::actors
