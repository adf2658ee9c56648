// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/fields.hpp"

#include "base/parallel.hpp"
#include "fem/quantities.hpp"
#include "fem/recovery.hpp"

namespace tedit::fem {

namespace {

/// An array over the slots of a version whose pages several threads fill; zeros where they do not.
class slot_array {
public:
  slot_array(std::size_t slots, std::size_t width) : size_(slots * width), width_(width) {
    using array = paged_array<double>;
    pages_.resize((size_ + array::items_per_page - 1) / array::items_per_page);
    parallel_for(
      pages_.size(),
      [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t p = first; p < last; ++p)
          pages_[p] = std::make_shared<page>(
            sizeof(double) * std::min(array::items_per_page, size_ - p * array::items_per_page));
      },
      16);
  }

  void set(std::size_t slot, const double* values) {
    using array = paged_array<double>;
    for (std::size_t i = slot * width_; i < (slot + 1) * width_; ++i, ++values) {
      auto* items = reinterpret_cast<double*>(pages_[i >> array::shift]->mutable_bytes().data());
      items[i & array::mask] = *values;
    }
  }

  [[nodiscard]] paged_array<double> freeze() {
    return *paged_array<double>::from_pages({pages_.begin(), pages_.end()}, size_);
  }

private:
  std::size_t size_, width_;
  std::vector<std::shared_ptr<page>> pages_;
};

/// Calls `set(slot, i)` for every owner that is a slot, on all cores.
template <class Set>
void for_each_owner(const std::vector<std::uint32_t>& owners, const Set& set) {
  parallel_for(owners.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      if (owners[i] != no_id)
        set(owners[i], i);
  });
}

field at_vertices(const mesh_version& mesh, const problem& p, const char* name,
                  std::span<const double> values, std::size_t width = 1, std::size_t stride = 0) {
  slot_array array(mesh.vertex_slots(), width);
  for_each_owner(p.node_vertices, [&](std::size_t slot, std::size_t n) {
    array.set(slot, &values[(stride == 0 ? width : stride) * n]);
  });
  return {name, field_location::vertex, static_cast<int>(width), array.freeze()};
}

/// At each corner node. A tensor's shears are half of the engineering shears.
std::vector<double> largest_strains(const solution& result) {
  std::vector<double> largest(result.nodal_strain.size() / 6);
  parallel_for(largest.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      const double* e = &result.nodal_strain[6 * n];
      const std::array<double, 6> strain{e[0], e[1], e[2], e[3] / 2, e[4] / 2, e[5] / 2};
      largest[n] = principal_values(strain.data())[0];
    }
  });
  return largest;
}

void add_at_tets(const mesh_version& mesh, const problem& p, const solution& result,
                 std::vector<field>& fields) {
  slot_array largest(mesh.tet_slots(), 1);
  slot_array stresses(mesh.tet_slots(), 6);
  slot_array errors(mesh.tet_slots(), 1);
  for_each_owner(p.element_tets, [&](std::size_t slot, std::size_t e) {
    const auto stress = element_stress(p, result.displacement, e);
    const double equivalent = von_mises(stress.data());
    const double error = result.element_error[e];
    largest.set(slot, &equivalent);
    stresses.set(slot, stress.data());
    errors.set(slot, &error);
  });
  using enum field_location;
  fields.push_back({"element_von_mises_pa", tet, 1, largest.freeze()});
  fields.push_back({"element_stress_pa", tet, 6, stresses.freeze()});
  fields.push_back({"element_error_sqrt_j", tet, 1, errors.freeze()});
}

}  // namespace

bool is_shown(const field& one) {
  const auto of_case = one.name.find(" (");
  const auto* row = find_array(std::string_view(one.name).substr(0, of_case));
  return !row || row->sent != array_sent::in_files;  // An envelope's has no row of its own.
}

std::vector<field> make_fields(const mesh_version& mesh, const problem& p, const solution& result,
                               field_range range) {
  const auto vertices = [&](const char* name, const auto& values, std::size_t width = 1,
                            std::size_t stride = 0) {
    return at_vertices(mesh, p, name, values, width, stride);
  };
  std::vector<field> fields{
    vertices("displacement_m", result.displacement, 3), vertices("von_mises_pa", result.von_mises),
    vertices("stress_pa", result.nodal_stress, 6), vertices("relative_error", result.nodal_error),
    vertices("largest_strain", largest_strains(result))};
  if (!result.safety_factor.empty())
    fields.push_back(vertices("safety_factor", result.safety_factor));
  if (range == field_range::all) {
    fields.push_back(vertices("reaction_n", result.reactions, 3));
    fields.push_back(vertices("principal_stress_pa", result.principal_stress, 1, 3));
    fields.push_back(vertices("strain", result.nodal_strain, 6));
    add_at_tets(mesh, p, result, fields);
  }
  return fields;
}

std::string case_field(std::string_view name, std::string_view load_case) {
  return std::string(name) + " (" + std::string(load_case) + ")";
}

std::vector<field> make_fields(const mesh_version& mesh, const case_set& set,
                               const solved_cases& result, field_range range) {
  const auto& p = set.problem;
  if (result.cases.size() == 1)
    return make_fields(mesh, p, result.cases.front(), range);
  const auto vertices = [&](const char* name, const std::vector<double>& values) {
    return at_vertices(mesh, p, name, values);
  };
  const auto& worst = result.envelope;
  std::vector<field> fields{
    vertices("envelope_von_mises", worst.von_mises),
    vertices("envelope_case", {worst.von_mises_case.begin(), worst.von_mises_case.end()})};
  if (!worst.safety_factor.empty()) {
    fields.push_back(vertices("envelope_safety_factor", worst.safety_factor));
    fields.push_back(vertices("envelope_safety_factor_case",
                              {worst.safety_factor_case.begin(), worst.safety_factor_case.end()}));
  }
  for (std::size_t c = 0; c < result.cases.size(); ++c)
    for (auto& one : make_fields(mesh, p, result.cases[c], range)) {
      one.name = case_field(one.name, set.cases[c].name);
      fields.push_back(std::move(one));
    }
  return fields;
}

std::vector<field> fields_of_case(const std::vector<field>& all, const std::string& load_case,
                                  bool several) {
  if (!several)
    return all;
  const auto ending = case_field("", load_case);
  std::vector<field> result;
  for (const auto& one : all)
    if (one.name.ends_with(ending)) {
      result.push_back(one);
      result.back().name.resize(one.name.size() - ending.size());
    }
  return result;
}

}  // namespace tedit::fem
