// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/comparison.hpp"

#include <algorithm>

#include "client/impl.hpp"
#include "fem/quantities.hpp"
#include "protocol/comparison.hpp"

namespace tedit::client {

namespace {

/// Errors: `protocol_error` for a mark that is none, or when there is not one for each vertex.
expected<std::vector<difference_mark>> read_marks(const incoming_stream& stream,
                                                  std::size_t vertices) {
  const auto bytes = stream.bytes(mark_array);
  if (!bytes)
    return fail(bytes.error());
  constexpr auto last = static_cast<unsigned char>(difference_mark::outside);
  const auto is_mark = [](char c) { return static_cast<unsigned char>(c) <= last; };
  if (bytes->size() != vertices || !std::ranges::all_of(*bytes, is_mark))
    return fail(ec::protocol_error,
                "a comparison's marks do not fit to its " + std::to_string(vertices) + " vertices");
  std::vector<difference_mark> marks;
  for (const char c : *bytes)
    marks.push_back(static_cast<difference_mark>(c));
  return marks;
}

/// Errors: `protocol_error` when an array has not a row for each vertex.
expected<void> read_differences(const incoming_stream& stream, comparison& to) {
  for (const auto& array : fem::result_arrays) {
    auto values = stream.f32(std::string(array.name) + std::string(difference_ending),
                             static_cast<unsigned>(array.components));
    if (!values)
      return fail(values.error());
    if (values->empty())
      continue;
    if (values->size() != to.vertices.size() * static_cast<std::size_t>(array.components))
      return fail(ec::protocol_error, "a comparison has " + std::to_string(to.vertices.size()) +
                                        " vertices and " + std::to_string(values->size()) +
                                        " values of " + std::string(array.name));
    to.differences[array.name] = std::move(*values);
  }
  return {};
}

}  // namespace

expected<comparison> read_comparison(const v1::VersionsCompared& message,
                                     const incoming_stream& stream) {
  comparison result{message.before(), message.after(), protocol::from_message(message),
                    message.load_case()};
  auto vertices = stream.u32("vertices", 1);
  if (!vertices)
    return fail(vertices.error());
  result.vertices = std::move(*vertices);
  auto marks = read_marks(stream, result.vertices.size());
  if (!marks)
    return fail(marks.error());
  result.marks = std::move(*marks);
  if (auto ok = read_differences(stream, result); !ok)
    return fail(ok.error());
  return result;
}

expected<comparison> client::compare(std::uint32_t before, std::uint32_t after,
                                     const std::string& load_case, const execution& run) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* wanted = request.mutable_compare_versions();
  wanted->set_document(*document);
  wanted->set_before(before);
  wanted->set_after(after);
  wanted->set_load_case(load_case);
  auto got = impl_->ask(std::move(request), body::kVersionsCompared, run);
  if (!got)
    return fail(std::move(got.error()));
  return read_comparison(got->message.versions_compared(), *got->bulk);
}

}  // namespace tedit::client
