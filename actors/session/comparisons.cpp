// SPDX-License-Identifier: AGPL-3.0-or-later
// What two versions differ in: put together by the session, worked out on a thread aside.

#include "actors/session/aside.hpp"
#include "base/logging/logging.hpp"
#include "compare/compare_fields.hpp"
#include "compare/compare_versions.hpp"
#include "fem/fields.hpp"

namespace tedit::actors {

namespace {

/// One of the two versions; the mesh and the load cases are as they were when it was asked.
struct compared_side {
  std::uint32_t number = 0;
  version_ptr mesh;
  shared_load_cases load_cases;

  [[nodiscard]] const fem::load_case* find(const std::string& name) const {
    const auto found = std::ranges::find(*load_cases, name, &fem::load_case::name);
    return found == load_cases->end() ? nullptr : &*found;
  }
};

/// The results of a load case in both versions.
struct compared_results {
  std::string load_case;
  solved before;
  solved after;
};

/// All that the thread needs; nothing of it changes any more.
struct comparison_work {
  compared_side before;
  compared_side after;
  std::vector<compared_results> pairs;
  std::vector<uncompared_fields> not_compared;
  std::string load_case;  ///< Whose difference is wanted.
};

compared_side side_of(const graph_node& node, const version_ptr& mesh) {
  return {node.info.number, mesh, node.load_cases};
}

/// All load cases of both: those of after, then those that only before has.
std::vector<std::string> all_cases(const compared_side& before, const compared_side& after) {
  auto names = names_of(*after.load_cases);
  for (const auto& one : *before.load_cases)
    if (!after.find(one.name))
      names.push_back(one.name);
  return names;
}

error no_such_case(const comparison_request& asked, const std::vector<std::string>& known) {
  std::string list;
  for (const auto& one : known)
    list += (list.empty() ? "\"" : ", \"") + one + "\"";
  return {ec::not_found,
          "neither version " + std::to_string(asked.before) + " nor version " +
            std::to_string(asked.after) + " has a load case \"" + asked.load_case + "\"",
          known.empty() ? "They have none" : "They have " + list,
          {}};
}

/// The arrays of one load case among those of a result.
std::vector<field> fields_in(const solved& result, const std::string& load_case) {
  return fem::fields_of_case(*result.fields, load_case, result.outcome->envelope.has_value());
}

/// Without the arrays that figures do not need: their difference would be made for nobody.
std::vector<field> for_figures(std::vector<field> all) {
  std::erase_if(all, [](const field& one) {
    return one.name != "von_mises_pa" && one.name != "safety_factor";
  });
  return all;
}

bool is_preview(const solved& result, const std::string& load_case) {
  const auto& cases = result.outcome->cases;
  const auto found = std::ranges::find(cases, load_case, &solve_report::load_case);
  return found != cases.end() && found->preview;
}

/// Adds what the fields of one load case differ in, or why they cannot be compared.
expected<void> add_pair(const comparison_work& work, const compared_results& pair,
                        const version_match& match, const execution& run,
                        version_comparison& result, std::vector<field>& difference) {
  const bool wanted = pair.load_case == work.load_case;
  auto was = fields_in(pair.before, pair.load_case);
  auto is = fields_in(pair.after, pair.load_case);
  if (!wanted) {
    was = for_figures(std::move(was));
    is = for_figures(std::move(is));
  }
  auto made = compare_fields({*work.before.mesh, was}, {*work.after.mesh, is}, match, run);
  if (!made && made.error().code == ec::cancelled)
    return fail(made.error());
  if (!made) {
    result.not_compared.push_back({pair.load_case, made.error().message, made.error().remedy});
    return {};
  }
  made->figures.load_case = pair.load_case;
  made->figures.preview =
    is_preview(pair.before, pair.load_case) || is_preview(pair.after, pair.load_case);
  result.fields.push_back(std::move(made->figures));
  if (wanted)
    difference = std::move(made->fields);
  return {};
}

/// On the thread.
expected<compared> carry_out(const comparison_work& work, const cancel_token& token) {
  const execution run{token, {}};
  const auto& before = *work.before.mesh;
  const auto& after = *work.after.mesh;
  const auto match = match_versions(before, after, run);
  if (!match)
    return fail(match.error());
  auto what = compare_versions({before, *work.before.load_cases}, {after, *work.after.load_cases},
                               *match, run);
  if (!what)
    return fail(what.error());
  what->not_compared = work.not_compared;
  std::vector<field> difference;
  for (const auto& pair : work.pairs)
    if (auto ok = add_pair(work, pair, *match, run, *what, difference); !ok)
      return fail(ok.error());
  compared result{{}, work.before.number, work.after.number, work.load_case, work.after.mesh};
  result.what = std::make_shared<const version_comparison>(std::move(*what));
  result.difference = std::make_shared<const std::vector<field>>(std::move(difference));
  return result;
}

}  // namespace

caf::result<compared> session_state::compare(const comparison_request& request) {
  for (const auto number : {request.before, request.after})
    if (number >= graph.nodes().size())
      return to_caf(no_version(number));
  const auto cases = all_cases(side_of(graph.nodes()[request.before], {}),
                               side_of(graph.nodes()[request.after], {}));
  if (!request.load_case.empty() && std::ranges::count(cases, request.load_case) == 0)
    return to_caf(no_such_case(request, cases));
  auto promise = self->make_response_promise<compared>();
  const cancel_token token;
  add_aside({request.ticket, token, [=, this] { begin_comparison(request, token, promise); },
             [=](const error& e) mutable { promise.deliver(to_caf(e)); }});
  return promise;
}

std::vector<const session_state::kept_result*> session_state::results_of(
  const graph_node& node, const std::string& load_case) const {
  std::vector<const kept_result*> found;
  const auto present = std::ranges::find(*node.load_cases, load_case, &fem::load_case::name);
  const auto version = to_hex(node.info.id);
  for (const auto& one : results)
    if (present != node.load_cases->end() && one.key.version == version &&
        std::ranges::count(one.key.load_cases, *present) > 0 && parts.results->has(one.shown))
      found.push_back(&one);
  return found;
}

namespace {

error no_field(const graph_node& node) {
  return {ec::not_found,
          "no field of version " + std::to_string(node.info.number) + " is at hand",
          "Go to that version and solve the load case, then compare again",
          {}};
}

}  // namespace

/// Of several results that fit the ones that were used last. What was at hand may have to give way
/// to others' results at any moment.
expected<std::pair<solved, solved>> session_state::results_to_compare(
  const graph_node& before, const graph_node& after, const std::string& load_case) const {
  const auto was = results_of(before, load_case);
  const auto is = results_of(after, load_case);
  for (const auto& [node, found] : {std::pair(&before, &was), std::pair(&after, &is)}) {
    if (std::ranges::count(*node->load_cases, load_case, &fem::load_case::name) == 0)
      return fail(ec::not_found,
                  "version " + std::to_string(node->info.number) + " has no such load case",
                  "Compare load cases that both versions have");
    if (found->empty())
      return fail(no_field(*node));
  }
  for (const auto* a : was)
    for (const auto* b : is)
      if (a->key.element_order == b->key.element_order) {
        auto first = with_fields(*a, nullptr);
        auto second = with_fields(*b, nullptr);
        if (first && second)
          return std::pair(std::move(*first), std::move(*second));
        return fail(no_field(first ? after : before));
      }
  return fail(ec::invalid_argument,
              "one version was solved with linear tets and the other with quadratic ones",
              "Solve both with the same element order, then compare again");
}

/// What cannot be had is compared without.
void session_state::bring_to_compare(std::uint32_t number, const std::string& load_case,
                                     const version_ptr& mesh,
                                     const std::function<void(bool)>& done) {
  const auto found = results_of(graph.nodes()[number], load_case);
  if (found.empty())
    return done(false);
  bring_watched(found.front()->event.number, mesh, done);
}

void session_state::begin_comparison(const comparison_request& request, const cancel_token& token,
                                     const caf::typed_response_promise<compared>& promise) {
  const auto refuse = [this](const error& e) { refuse_aside(e); };
  const auto take_after = [=, this](const version_ptr& before) {
    with_mesh(
      request.after,
      [=, this](const version_ptr& after) {
        const auto run = [=, this](bool) {
          run_comparison(request, {before, after}, token, promise);
        };
        bring_to_compare(request.before, request.load_case, before, [=, this](bool) {
          bring_to_compare(request.after, request.load_case, after, run);
        });
      },
      refuse);
  };
  with_mesh(request.before, take_after, refuse);
}

/// The fields are those at hand when its turn has come.
void session_state::run_comparison(const comparison_request& request,
                                   const std::pair<version_ptr, version_ptr>& meshes,
                                   const cancel_token& token,
                                   const caf::typed_response_promise<compared>& promise) {
  const auto& before = graph.nodes()[request.before];
  const auto& after = graph.nodes()[request.after];
  auto work = std::make_shared<comparison_work>(comparison_work{
    side_of(before, meshes.first), side_of(after, meshes.second), {}, {}, request.load_case});
  for (const auto& load_case : all_cases(work->before, work->after)) {
    if (auto found = results_to_compare(before, after, load_case))
      work->pairs.push_back({load_case, std::move(found->first), std::move(found->second)});
    else
      work->not_compared.push_back({load_case, found.error().message, found.error().remedy});
  }
  do_aside<compared>(
    promise, [=] { return carry_out(*work, token); }, "the comparison");
}

}  // namespace tedit::actors
