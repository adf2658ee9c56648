// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/checks.hpp"
#include "ops/conformance/child.hpp"
#include "ops/conformance/conformance.hpp"
#include "ops/conformance/meshes.hpp"
#include "ops/loader/catalogue.hpp"

/// Inside of the kit: what its checks share.
namespace tedit::ops::kit {

/// The operations that a plugin may ask for (`context::apply_other`): those of the program. The
/// first call loads them, which a confined process cannot.
[[nodiscard]] const catalogue& built_in_operations();

/// A selection that the operation accepts, found by the survey.
struct working_case {
  std::size_t sample = 0;
  std::vector<surface_id> surfaces;
};

/// A check ends by throwing its failure: it lives in the child and nothing goes on after it.
struct failure {
  std::string seen;
  std::string remedy;
};

/// A rule that an edit breaks.
struct broken_rule {
  std::string rule;
  std::string seen;
};

/// What the parent knows when it starts a check.
struct plan {
  const conformance_settings* settings = nullptr;
  std::vector<sample> samples;       ///< The kit's own, then the part.
  std::vector<working_case> cases;   ///< At most one for each sample, cheapest kinds first.
  std::size_t refusals = 0;          ///< What the survey saw refused,
  std::vector<failure> unexplained;  ///< and the first of those that do not say why or what to do.
  std::uint32_t operation = 0;       ///< Index in the plugin.
  /// What the results of the working cases break, once a check has looked at all of it: others
  /// about results need not make them again.
  std::optional<std::vector<broken_rule>> broken;
  /// Likewise what they leave behind.
  std::optional<std::vector<broken_rule>> left_behind;
  std::vector<std::string> versions;  ///< Of the working cases, once they are known to be the same.
  bool faulty = false;  ///< A rule about results is known to be broken: other checks leave it out.
};

/// A check that cannot say anything.
struct not_applicable {
  std::string why;
};

/// The plugin as one check sees it, inside the child.
class plugin_trial {
public:
  plugin_trial(const plan& p, const child_reporter& reporter) : plan_(p), reporter_(reporter) {}

  // -- loading, step by step: each throws `failure` ---------------------------------------------

  void open();        ///< dlopen.
  void find_entry();  ///< dlsym and the call.
  /// All of the above and the instance.
  void load();
  [[nodiscard]] std::shared_ptr<const operation> make() const;
  [[nodiscard]] const plugin_descriptor& descriptor() const { return *descriptor_; }

  // -- running ----------------------------------------------------------------------------------

  [[nodiscard]] const plan& the_plan() const { return plan_; }
  [[nodiscard]] const operation_description& description() const { return description_; }
  [[nodiscard]] const operation& code() const { return *code_; }
  [[nodiscard]] const sample& sample_of(const working_case& c) const {
    return plan_.samples[c.sample];
  }

  /// Starts a step: the time limit anew.
  void mark(const std::string& what) const { reporter_.mark(what); }
  void say(const std::string& line) const { reporter_.say(line); }

  /// The defaults, with the settings' values.
  [[nodiscard]] parameters values() const;

  /// One call of `apply` as the host makes it. Throws `failure` when the plugin throws.
  [[nodiscard]] expected<edit_result> apply(const version_ptr& mesh,
                                            const std::vector<surface_id>& surfaces,
                                            const parameters& with,
                                            const execution& run = {}) const {
    return apply_by(*code_, mesh, surfaces, with, run);
  }
  [[nodiscard]] expected<edit_result> apply_by(const operation& code, const version_ptr& mesh,
                                               const std::vector<surface_id>& surfaces,
                                               const parameters& with,
                                               const execution& run = {}) const;

  /// The result on a case that worked before; else throws `failure`.
  [[nodiscard]] edit_result succeed(const working_case& c, const execution& run = {}) const;

private:
  const plan& plan_;
  const child_reporter& reporter_;
  void* library_ = nullptr;
  const plugin_descriptor* descriptor_ = nullptr;
  std::shared_ptr<const operation> code_;
  operation_description description_;
  std::function<void(std::string_view)> log_;  ///< To the child's stderr.
};

/// What a check needs before it makes sense.
enum class need { nothing, plugin, working_case, deterministic };

struct check {
  const char* name;
  const char* rule;
  need needs;
  /// Returns what was seen. Throws `failure` or `not_applicable`.
  std::string (*run)(plugin_trial&);
};

// -- the checks by topic, each list in its own file -----------------------------------------------

[[nodiscard]] const std::vector<check>& file_checks();
[[nodiscard]] const std::vector<check>& description_checks();
[[nodiscard]] const std::vector<check>& survey_checks();  ///< These find the working cases.
[[nodiscard]] const std::vector<check>& result_checks();
[[nodiscard]] const std::vector<check>& running_checks();
[[nodiscard]] const std::vector<check>& selection_checks();
[[nodiscard]] const std::vector<check>& parameter_checks();
[[nodiscard]] const std::vector<check>& residue_checks();

// -- what the survey says to the parent, a line each
// -----------------------------------------------

constexpr std::string_view refused = "refused";  ///< Followed by what it lacks, if it lacks any.

// -- and other checks, for those that come after them ---------------------------------------------

constexpr std::string_view breaks = "breaks ";       ///< A rule, a tab, and what was seen.
constexpr std::string_view leaves = "leaves ";       ///< The same of what is left behind.
constexpr std::string_view version_is = "version ";  ///< Of the next working case, hexadecimal.
constexpr std::string_view looked_at = "all was looked at";
constexpr std::string_view remedy_mark = " remedy: ";  ///< What follows is the failure's remedy.

// -- helpers
// ---------------------------------------------------------------------------------------

/// "11, 12 of the drilled block".
[[nodiscard]] std::string where(const plugin_trial& b, const working_case& c);

/// What a candidate breaks, apart from quality and from what its base broke already.
[[nodiscard]] std::vector<finding> faults_of(const mesh_version& base, const edit_result& edit);

/// "positive orientation at tet 3 (volume -1e-9 m3)".
[[nodiscard]] std::string to_text(const finding& f);

/// An answer that the host could use: a candidate without faults, or an error with a message.
/// Throws `failure` otherwise. Returns true for a candidate.
bool check_answer(const plugin_trial& b, const mesh_version& mesh,
                  const expected<edit_result>& answer, const std::string& what);

/// An error says what is wrong and what to do; `cancelled` and `out_of_memory` need no remedy.
void check_refusal(const error& e, const std::string& what);

}  // namespace tedit::ops::kit
