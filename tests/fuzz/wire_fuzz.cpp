// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cstring>
#include <vector>

#include "mesh/checks.hpp"
#include "ops/loader/edit_answer.hpp"
#include "tests/fuzz/promise.hpp"
#include "tests/support/blocks.hpp"

namespace {

using namespace tedit;

/// A bar of 2 x 1 x 1 mm, some dozen tets.
const mesh_version& part() {
  static const auto made = test::blocks(
    {2, 1, 1}, [](int, int, int) { return true; }, [](vec3 p) { return 1e-3 * p; });
  return *made;
}

/// A list of pages from another node or a document's file.
void read_manifest(std::span<const std::uint8_t> bytes) {
  const auto list = manifest::from_bytes(std::as_bytes(bytes));
  if (!list)
    return fuzz::require_reason(list.error());
  const auto again = list->to_bytes();
  fuzz::require(std::ranges::equal(again, std::as_bytes(bytes)), "a manifest has one form");
  const auto built = mesh_version::from_manifest(*list, [](const hash128&) { return page_ptr(); });
  if (!built)
    return fuzz::require_reason(built.error());
  static_cast<void>(check_version(**built));
}

/// What a process with a plugin in it says its edit came to.
void read_answer(std::span<const std::uint8_t> bytes) {
  const auto answer = ops::answer_from_bytes(std::as_bytes(bytes), part());
  if (!answer)
    return;  // The plugin's own words, or that it gave no answer.
  fuzz::require(answer->candidate != nullptr, "an answer has a candidate");
  static_cast<void>(check_version(*answer->candidate));
}

std::vector<page_ptr> distinct_pages() {
  std::vector<page_ptr> pages;
  part().for_each_page([&](const page_ptr& one) { pages.push_back(one); });
  return pages;
}

/// Numbers of a sound version are overwritten: each change has page, place and four bytes, or one
/// of the counts. The check must come back with what is wrong.
void check_damaged(fuzz::input in) {
  static const auto sound = distinct_pages();
  auto list = part().pages();
  std::vector<std::vector<std::byte>> contents;
  for (const auto& one : sound)
    contents.emplace_back(one->bytes().begin(), one->bytes().end());
  bool changed = false;
  for (int i = 0; i < 64 && !in.at_end(); ++i) {
    const auto which = static_cast<std::size_t>(in.number(1));
    const auto place = static_cast<std::size_t>(in.number(2));
    const auto value = static_cast<std::uint32_t>(in.number(4));
    changed = true;
    if (which >= 0xf0) {
      list.counts[place % list.counts.size()] = value;
      continue;
    }
    auto& bytes = contents[which % contents.size()];
    std::memcpy(bytes.data() + place * 4 % (bytes.size() / 4 * 4), &value, 4);
  }
  const auto find = [&](const hash128& id) -> page_ptr {
    for (std::size_t i = 0; i < sound.size(); ++i)
      if (sound[i]->id() == id)
        return page::from_bytes(contents[i]);
    return nullptr;
  };
  const auto built = mesh_version::from_manifest(list, find);
  if (!built)
    return fuzz::require_reason(built.error());
  const auto report = check_version(**built);
  fuzz::require(changed || report.ok(), "a sound version is sound");
  for (const auto& one : report.findings)
    fuzz::require(!one.rule.empty(), "a finding names its rule");
  if (report.ok())  // As a session does with a candidate.
    static_cast<void>(check_edit(part(), **built, {}));
}

}  // namespace

/// The first byte says as what the rest is read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in({data, size});
  switch (in.number(1) % 3) {
    case 0:
      read_manifest(in.rest());
      break;
    case 1:
      read_answer(in.rest());
      break;
    default:
      check_damaged(in);
  }
  return 0;
}
