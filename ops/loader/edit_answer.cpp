// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/edit_answer.hpp"

#include <unordered_map>

#include "base/byte_stream.hpp"

namespace tedit::ops {

namespace {

using page_table = std::unordered_map<hash128, page_ptr>;

page_table pages_of(const mesh_version& mesh) {
  page_table result;
  mesh.for_each_page([&](const page_ptr& p) { result.emplace(p->id(), p); });
  return result;
}

void write_version(const mesh_version& mesh, const mesh_version& base, byte_writer& out) {
  out.list(std::span<const std::byte>(mesh.pages().to_bytes()));
  const auto known = pages_of(base);
  std::vector<page_ptr> fresh;
  mesh.for_each_page([&](const page_ptr& p) {
    if (!known.contains(p->id()))
      fresh.push_back(p);
  });
  out.number(static_cast<std::uint64_t>(fresh.size()));
  for (const auto& p : fresh)
    out.list(p->bytes());
}

expected<version_ptr> read_version(byte_reader& in, const mesh_version& base) {
  const auto list = manifest::from_bytes(in.list<std::byte>());
  if (!list)
    return fail(list.error());
  auto pages = pages_of(base);
  const auto fresh = in.count(sizeof(std::uint64_t));
  for (std::size_t i = 0; i < fresh && in.ok; ++i) {
    auto made = page::from_bytes(in.raw(in.count(1)));
    pages.emplace(made->id(), std::move(made));
  }
  return mesh_version::from_manifest(*list, [&](const hash128& id) -> page_ptr {
    const auto found = pages.find(id);
    return found == pages.end() ? nullptr : found->second;
  });
}

void write_error(const error& e, byte_writer& out) {
  out.text(code_name(e.code));
  for (const auto* text : {&e.message, &e.remedy, &e.where})
    out.text(*text);
  out.number(static_cast<std::uint8_t>(e.most.has_value()));
  if (!e.most)
    return;
  out.text(e.most->parameter);
  out.number(e.most->value);
}

error read_error(byte_reader& in) {
  error e;
  e.code = code_from_name(in.text());
  for (auto* text : {&e.message, &e.remedy, &e.where})
    *text = in.text();
  if (in.number<std::uint8_t>() == 0)
    return e;
  auto& most = e.most.emplace();
  most.parameter = in.text();
  most.value = in.number<double>();
  return e;
}

void write_words(const edit_result& edit, byte_writer& out) {
  out.number(static_cast<std::uint64_t>(edit.notices.size()));
  for (const auto& notice : edit.notices)
    out.text(notice);
  out.number(static_cast<std::uint64_t>(edit.figures.size()));
  for (const auto& f : edit.figures) {
    out.number(f.value);
    for (const auto* text : {&f.id, &f.unit, &f.help})
      out.text(*text);
  }
}

void read_words(byte_reader& in, edit_result& edit) {
  edit.notices.resize(in.count(sizeof(std::uint32_t)));
  for (auto& notice : edit.notices)
    notice = in.text();
  edit.figures.resize(in.count(sizeof(double)));
  for (auto& f : edit.figures) {
    f.value = in.number<double>();
    for (auto* text : {&f.id, &f.unit, &f.help})
      *text = in.text();
  }
}

/// The fields that are numbers and lists of numbers, in one order for both ways.
template <class Edit, class Number, class List>
void for_each_number(Edit& edit, const Number& number, const List& list) {
  list(edit.touched);
  number(edit.volume_change);
  number(edit.improve);
  number(edit.thorough);
  list(edit.surfaces_used);
  number(edit.quality_floor);
  number(edit.bodies_added);
}

}  // namespace

std::vector<std::byte> to_bytes(const expected<edit_result>& answer, const mesh_version& base) {
  byte_writer out;
  out.number(static_cast<std::uint8_t>(answer.has_value()));
  if (!answer) {
    write_error(answer.error(), out);
    return std::move(out.bytes);
  }
  for_each_number(
    *answer, [&](const auto& value) { out.number(value); },
    [&](const auto& items) { out.list(std::span(items)); });
  write_words(*answer, out);
  write_version(*answer->candidate, base, out);
  return std::move(out.bytes);
}

expected<edit_result> answer_from_bytes(std::span<const std::byte> bytes,
                                        const mesh_version& base) {
  byte_reader in(bytes);
  if (in.number<std::uint8_t>() == 0)
    return fail(in.ok ? read_error(in) : error{ec::protocol_error, "gave no answer", {}, {}});
  edit_result edit;
  for_each_number(
    edit, [&](auto& value) { value = in.number<std::remove_reference_t<decltype(value)>>(); },
    [&](auto& items) {
      items = in.list<typename std::remove_reference_t<decltype(items)>::value_type>();
    });
  read_words(in, edit);
  auto candidate = read_version(in, base);
  if (!candidate || !in.ok || !in.at_end() || edit.improve < improvement::none ||
      edit.improve > improvement::thorough)
    return fail(ec::protocol_error, "gave an answer that cannot be read" +
                                      (candidate ? "" : ": " + candidate.error().message));
  edit.candidate = std::move(*candidate);
  return edit;
}

}  // namespace tedit::ops
