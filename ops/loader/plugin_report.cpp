// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/plugin_report.hpp"

#include <algorithm>

#include "base/byte_stream.hpp"
#include "base/text.hpp"

namespace tedit::ops {

namespace {

/// Before all else: bytes of another program, or of another version of this one, are none.
constexpr std::uint32_t report_tag = 0x31504552;  // "REP1"

constexpr std::size_t most_reason = 2000;

/// What an operation and a parameter take at least: counts beyond are none.
constexpr std::size_t least_operation = 64;
constexpr std::size_t least_parameter = 36;

/// The fields of a parameter, in one order for all that go over them.
template <class Fields, class Parameter>
void for_each_field_of_one(Parameter& p, Fields& fields) {
  for (auto* text : {&p.id, &p.name, &p.help, &p.unit, &p.instead_of})
    fields(*text);
  fields(p.type);
  fields(p.min);
  fields(p.max);
  fields(p.choices);
  fields(p.default_value);
}

/// Those of an operation.
template <class Fields, class Operation>
void for_each_field(Operation& one, Fields& fields) {
  auto& d = one.description;
  for (auto* text : {&d.id, &d.name, &d.summary, &d.version, &d.selection.help, &d.icon, &d.guide,
                     &d.best_for, &one.plugin})
    fields(*text);
  fields(d.selection.minimum);
  fields(d.selection.maximum);
  fields(d.rank);
  fields(d.parameters);
}

struct field_writer {
  byte_writer out = {};

  void operator()(const std::string& text) { out.text(text); }
  void operator()(std::size_t value) { out.number(static_cast<std::uint64_t>(value)); }
  void operator()(int value) { out.number(value); }
  void operator()(parameter_type type) { out.number(type); }
  void operator()(const std::optional<double>& limit) {
    out.number(static_cast<std::uint8_t>(limit.has_value()));
    out.number(limit.value_or(0));
  }
  void operator()(const parameter_value& value) {
    out.number(static_cast<std::uint8_t>(value.index()));
    std::visit([&](const auto& v) { write(v); }, value);
  }
  void operator()(const std::vector<std::string>& choices) {
    out.number(static_cast<std::uint64_t>(choices.size()));
    for (const auto& choice : choices)
      out.text(choice);
  }
  void operator()(const std::vector<parameter_description>& parameters) {
    out.number(static_cast<std::uint64_t>(parameters.size()));
    for (const auto& p : parameters)
      for_each_field_of_one(p, *this);
  }

private:
  void write(bool value) { out.number(static_cast<std::uint8_t>(value)); }
  void write(const std::string& value) { out.text(value); }
  template <class Number>
  void write(Number value) {
    out.number(value);
  }
};

struct field_reader {
  byte_reader in;

  void operator()(std::string& text) { text = in.text(); }
  void operator()(std::size_t& value) { value = in.number<std::uint64_t>(); }
  void operator()(int& value) { value = in.number<int>(); }
  void operator()(parameter_type& type) {
    const auto number = in.number<std::underlying_type_t<parameter_type>>();
    in.ok = in.ok && number >= 0 && number <= static_cast<int>(parameter_type::list);
    type = in.ok ? static_cast<parameter_type>(number) : parameter_type::text;
  }
  void operator()(std::optional<double>& limit) {
    const bool there = flag();
    const auto value = in.number<double>();
    limit = there ? std::optional(value) : std::nullopt;
  }
  void operator()(parameter_value& value) {
    const auto kind = in.number<std::uint8_t>();
    if (kind == 0)
      value = flag();
    else if (kind == 1)
      value = in.number<std::int64_t>();
    else if (kind == 2)
      value = in.number<double>();
    else
      value = in.text();
    in.ok = in.ok && kind <= 3;
  }
  void operator()(std::vector<std::string>& choices) {
    choices.resize(in.count(sizeof(std::uint32_t)));
    for (auto& choice : choices)
      choice = in.text();
  }
  void operator()(std::vector<parameter_description>& parameters) {
    parameters.resize(in.count(least_parameter));
    for (auto& p : parameters)
      for_each_field_of_one(p, *this);
  }

private:
  bool flag() {
    const auto value = in.number<std::uint8_t>();
    in.ok = in.ok && value <= 1;
    return value == 1;
  }
};

bool is_control(char c) {
  return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

/// Lines and columns may be there; what else moves a terminal's cursor, or sets its colours, not.
bool can_be_shown(const std::string& text) {
  return is_utf8(text) && std::ranges::none_of(text, [](char c) {
           return is_control(c) && c != '\n' && c != '\t' && c != '\r';
         });
}

struct text_judge {
  bool good = true;

  void operator()(const std::string& text) { good = good && can_be_shown(text); }
  void operator()(const parameter_value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
      (*this)(*text);
  }
  void operator()(const std::vector<std::string>& choices) {
    for (const auto& choice : choices)
      (*this)(choice);
  }
  void operator()(const std::vector<parameter_description>& parameters) {
    for (const auto& p : parameters)
      for_each_field_of_one(p, *this);
  }
  void operator()(std::size_t) {}
  void operator()(int) {}
  void operator()(parameter_type) {}
  void operator()(const std::optional<double>&) {}
};

std::string one_line(std::string_view reason) {
  auto line = to_utf8(reason);
  std::ranges::replace_if(line, is_control, ' ');
  return std::string(cut_text(line, most_reason));
}

std::vector<std::byte> bytes_of(const plugin_report& report) {
  field_writer fields;
  fields.out.number(report_tag);
  fields(report.refusal);
  fields(report.operations.size());
  for (const auto& one : report.operations)
    for_each_field(one, fields);
  return std::move(fields.out.bytes);
}

}  // namespace

std::string text_fault(const described_operation& one) {
  text_judge texts;
  for_each_field(one, texts);
  return texts.good ? "" : "its description holds control characters, or bytes that are no UTF-8";
}

std::vector<std::byte> to_bytes(const plugin_report& report) {
  auto bytes = bytes_of(report);
  if (bytes.size() <= most_report_bytes)
    return bytes;
  return bytes_of(
    {report.refusal.empty() ? "its description is longer than 4 MiB" : one_line(report.refusal),
     {}});
}

expected<plugin_report> report_from_bytes(std::span<const std::byte> bytes) {
  const auto unreadable = [] {
    return fail(ec::protocol_error, "gave no answer that can be read");
  };
  field_reader fields{byte_reader(bytes)};
  auto& in = fields.in;
  if (bytes.size() > most_report_bytes || in.number<std::uint32_t>() != report_tag)
    return unreadable();
  plugin_report report;
  report.refusal = one_line(in.text());
  report.operations.resize(in.count(least_operation));
  for (auto& one : report.operations)
    for_each_field(one, fields);
  if (!in.ok || !in.at_end() || report.refusal.empty() == report.operations.empty())
    return unreadable();
  for (const auto& one : report.operations)
    if (!text_fault(one).empty())
      return unreadable();
  return report;
}

bool is_same(const described_operation& a, const described_operation& b) {
  return bytes_of({"", {a}}) == bytes_of({"", {b}});
}

}  // namespace tedit::ops
