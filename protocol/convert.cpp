// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/convert.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include <google/protobuf/util/json_util.h>

#include "base/text.hpp"
#include "protocol/json.hpp"
#include "protocol/json_faults.hpp"
#include "protocol/load_case_message.hpp"
#include "protocol/numbers.hpp"
#include "protocol/vector_message.hpp"
#include "tedit/v1/load_case.pb.h"

namespace tedit::protocol {

namespace {

template <class Surfaces>
std::vector<surface_id> surfaces_from(const Surfaces& surfaces) {
  return {surfaces.begin(), surfaces.end()};
}

expected<fem::material> material_from(const v1::Material& m) {
  fem::material result{m.name(),          m.young_modulus_pa(),  m.poisson_ratio(),
                       m.density_kg_m3(), m.yield_strength_pa(), {}};
  for (const auto region : m.regions()) {
    if (region < std::numeric_limits<region_id>::min() ||
        region > std::numeric_limits<region_id>::max())
      return fail(ec::bad_input, "material \"" + m.name() + "\" names region " +
                                   std::to_string(region) + ", which no mesh can have");
    result.regions.push_back(static_cast<region_id>(region));
  }
  return result;
}

expected<fem::constraint> constraint_from(const v1::Constraint& c, int index) {
  fem::constraint result{surfaces_from(c.surfaces()), fem::fixed{}, c.warning()};
  switch (c.kind_case()) {
    case v1::Constraint::kFixed:
      return result;
    case v1::Constraint::kRoller:
      result.kind = fem::roller{};
      return result;
    case v1::Constraint::kDisplacement: {
      const auto& d = c.displacement();
      fem::prescribed_displacement values;
      if (d.has_x_m())
        values.x_m = d.x_m();
      if (d.has_y_m())
        values.y_m = d.y_m();
      if (d.has_z_m())
        values.z_m = d.z_m();
      result.kind = values;
      return result;
    }
    case v1::Constraint::KIND_NOT_SET:
      break;
  }
  return fail(ec::bad_input, "constraint " + std::to_string(index) + " says no kind",
              "Give it one of fixed, displacement, roller");
}

expected<fem::load> load_from(const v1::Load& l, int index) {
  fem::load result{surfaces_from(l.surfaces()), fem::force{}, l.warning()};
  switch (l.kind_case()) {
    case v1::Load::kForce:
      result.kind = fem::force{read_vector(l.force().total_n())};
      return result;
    case v1::Load::kTraction:
      result.kind = fem::traction{read_vector(l.traction().pa())};
      return result;
    case v1::Load::kPressure:
      result.kind = fem::pressure{l.pressure().pa(), read_vector(l.pressure().gradient_pa_m()),
                                  read_vector(l.pressure().at_m())};
      return result;
    case v1::Load::kGravity:
      result.kind = fem::gravity{read_vector(l.gravity().m_s2())};
      return result;
    case v1::Load::kNormalForce:
      result.kind = fem::normal_force{l.normal_force().total_n()};
      return result;
    case v1::Load::kMoment:
      result.kind = fem::moment{read_vector(l.moment().total_nm())};
      return result;
    case v1::Load::kRemoteForce: {
      const auto& f = l.remote_force();
      result.kind = fem::remote_force{read_vector(f.total_n()), read_vector(f.at_m()),
                                      read_vector(f.moment_nm())};
      return result;
    }
    case v1::Load::kBearingForce:
      result.kind = fem::bearing_force{read_vector(l.bearing_force().total_n())};
      return result;
    case v1::Load::KIND_NOT_SET:
      break;
  }
  return fail(ec::bad_input, "load " + std::to_string(index) + " says no kind",
              "Give it one of force, normal_force, traction, pressure, moment, remote_force, "
              "bearing_force, gravity");
}

/// Names go into reports, receipts, files and every message about a version.
constexpr std::size_t longest_name = 200;

/// Errors: `bad_input` for a name that is too long or has control characters.
expected<void> check_name(const std::string& name, const char* whose) {
  const bool control = std::ranges::any_of(
    name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  if (name.size() <= longest_name && !control)
    return {};
  return fail(ec::bad_input,
              "the name of a " + std::string(whose) + " has " +
                (control ? "control characters"
                         : std::to_string(name.size()) + " bytes: \"" +
                             std::string(cut_text(name, 40)) + "...\""),
              "Take one line of at most " + std::to_string(longest_name) + " bytes");
}

expected<void> check_names(const v1::LoadCase& message) {
  auto ok = check_name(message.name(), "load case");
  for (const auto& m : message.materials())
    if (ok)
      ok = check_name(m.name(), "material");
  return ok;
}

}  // namespace

expected<fem::load_case> from_message(const v1::LoadCase& message) {
  auto ok = check_numbers(message, any_number(), ec::bad_input);
  if (ok)
    ok = check_names(message);
  if (!ok)
    return fail(ok.error());
  fem::load_case result;
  result.name = message.name();
  for (const auto& m : message.materials()) {
    auto converted = material_from(m);
    if (!converted)
      return fail(converted.error());
    result.materials.push_back(std::move(*converted));
  }
  for (int i = 0; i < message.constraints_size(); ++i) {
    auto converted = constraint_from(message.constraints(i), i);
    if (!converted)
      return fail(converted.error());
    result.constraints.push_back(std::move(*converted));
  }
  for (int i = 0; i < message.loads_size(); ++i) {
    auto converted = load_from(message.loads(i), i);
    if (!converted)
      return fail(converted.error());
    result.loads.push_back(std::move(*converted));
  }
  return result;
}

namespace {

struct constraint_writer {
  v1::Constraint* out;

  void operator()(const fem::fixed&) const { out->mutable_fixed(); }
  void operator()(const fem::roller&) const { out->mutable_roller(); }
  void operator()(const fem::prescribed_displacement& d) const {
    auto* values = out->mutable_displacement();
    if (d.x_m)
      values->set_x_m(*d.x_m);
    if (d.y_m)
      values->set_y_m(*d.y_m);
    if (d.z_m)
      values->set_z_m(*d.z_m);
  }
};

struct load_writer {
  v1::Load* out;

  void operator()(const fem::force& f) const {
    write_vector(f.total_n, out->mutable_force()->mutable_total_n());
  }
  void operator()(const fem::traction& t) const {
    write_vector(t.pa, out->mutable_traction()->mutable_pa());
  }
  void operator()(const fem::pressure& p) const {
    auto* values = out->mutable_pressure();
    values->set_pa(p.pa);
    if (p.gradient_pa_m != vec3{})
      write_vector(p.gradient_pa_m, values->mutable_gradient_pa_m());
    if (p.at_m != vec3{})
      write_vector(p.at_m, values->mutable_at_m());
  }
  void operator()(const fem::gravity& g) const {
    write_vector(g.m_s2, out->mutable_gravity()->mutable_m_s2());
  }
  void operator()(const fem::normal_force& f) const {
    out->mutable_normal_force()->set_total_n(f.total_n);
  }
  void operator()(const fem::moment& m) const {
    write_vector(m.total_nm, out->mutable_moment()->mutable_total_nm());
  }
  void operator()(const fem::remote_force& f) const {
    auto* values = out->mutable_remote_force();
    write_vector(f.total_n, values->mutable_total_n());
    write_vector(f.at_m, values->mutable_at_m());
    if (f.moment_nm != vec3{})
      write_vector(f.moment_nm, values->mutable_moment_nm());
  }
  void operator()(const fem::bearing_force& f) const {
    write_vector(f.total_n, out->mutable_bearing_force()->mutable_total_n());
  }
};

}  // namespace

void to_message(const fem::load_case& loads, v1::LoadCase* out) {
  out->set_name(loads.name);
  for (const auto& m : loads.materials) {
    auto* row = out->add_materials();
    row->set_name(m.name);
    row->set_young_modulus_pa(m.young_modulus_pa);
    row->set_poisson_ratio(m.poisson_ratio);
    row->set_density_kg_m3(m.density_kg_m3);
    row->set_yield_strength_pa(m.yield_strength_pa);
    row->mutable_regions()->Assign(m.regions.begin(), m.regions.end());
  }
  for (const auto& c : loads.constraints) {
    auto* row = out->add_constraints();
    row->mutable_surfaces()->Assign(c.surfaces.begin(), c.surfaces.end());
    std::visit(constraint_writer{row}, c.kind);
    row->set_warning(c.warning);
  }
  for (const auto& l : loads.loads) {
    auto* row = out->add_loads();
    row->mutable_surfaces()->Assign(l.surfaces.begin(), l.surfaces.end());
    std::visit(load_writer{row}, l.kind);
    row->set_warning(l.warning);
  }
}

namespace {

/// What is no text of UTF-8 is told as such: the parser's words name letters that nobody sees.
expected<std::string_view> as_text(std::string_view json, const std::string& source) {
  if (json.empty())
    return fail(ec::bad_input, "this is no load case: it is empty", "Write the file again", source);
  if (!is_utf8(json))
    return fail(ec::bad_input, "this is no load case: it is no text in UTF-8",
                "Save it as UTF-8, or choose a file of JSON", source);
  return without_mark(json);
}

}  // namespace

expected<fem::load_case> load_case_from_json(std::string_view json, const std::string& source) {
  if (const auto text = as_text(json, source))
    json = *text;
  else
    return fail(text.error());
  v1::LoadCase message;
  google::protobuf::util::JsonParseOptions options;
  options.ignore_unknown_fields = false;
  const auto status = google::protobuf::util::JsonStringToMessage(
    google::protobuf::StringPiece(json.data(), json.size()), &message, options);
  if (!status.ok()) {
    const auto fault = json_fault_of(json, {status.message().data(), status.message().size()});
    return fail(ec::bad_input, "this is no load case: " + fault.message,
                fault.place.starts_with("line")
                  ? "Correct the text there"
                  : "See the message LoadCase in protocol/tedit/v1/load_case.proto",
                source + (fault.place.empty() ? "" : ", " + fault.place));
  }
  auto result = from_message(message);
  if (!result) {
    auto failure = result.error();
    failure.where = source;
    return fail(std::move(failure));
  }
  return result;
}

expected<fem::load_case> load_case_from_file(const std::filesystem::path& path) {
  constexpr std::uintmax_t largest = 16 * 1024 * 1024;
  std::error_code code;
  // A pipe or a device may never end, and a folder has no bytes.
  const bool is_file = std::filesystem::is_regular_file(path, code);
  const auto size = is_file ? std::filesystem::file_size(path, code) : 0;
  std::ifstream in;
  if (is_file)
    in.open(path, std::ios::binary);
  if (!is_file || code || !in)
    return fail(ec::io_error, "cannot read the load case " + path.string(),
                "Check the path and its permissions");
  if (size > largest)
    return fail(ec::bad_input, path.string() + " is too large for a load case (more than 16 MiB)",
                "Choose the file of a load case");
  std::ostringstream text;
  text << in.rdbuf();
  return load_case_from_json(text.str(), path.string());
}

std::string load_case_to_json(const fem::load_case& loads) {
  v1::LoadCase message;
  to_message(loads, &message);
  return message_to_json(message, true);
}

}  // namespace tedit::protocol
