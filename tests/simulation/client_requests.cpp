// SPDX-License-Identifier: AGPL-3.0-or-later
// What a simulated client asks for, by the step of the scenario.
#include "protocol/load_case_message.hpp"
#include "tests/simulation/client.hpp"

namespace tedit::simulation {

namespace {

/// Copies are opened by nobody: they stay what they were when they were made.
std::string name_of_copy(std::uint32_t value) {
  return copy_prefix + std::to_string(value % 3);
}

}  // namespace

template <class Body>
void simulated_client::set_terms(Body* body, request& made, const scenario_step& step) {
  body->set_document(document_);
  made.edit_id = name_ + "-" + std::to_string(++last_edit_);
  body->set_edit_id(made.edit_id);
  if constexpr (requires { body->set_expected_version(head_); })
    if (step.value % 5 == 0)
      body->set_expected_version(head_);
}

std::optional<simulated_client::request> simulated_client::make_request(const scenario_step& step) {
  request made;
  auto& message = made.message;
  const auto edit = [&](v1::ApplyEdit* body) {
    body->set_operation("nudge");
    (*body->mutable_parameters())["vertex"].set_real(step.value % 9);
    (*body->mutable_parameters())["by"].set_real(1e-3 * (1 + step.value % 7));
  };
  const auto load_case = "load " + std::to_string(step.value % 3);
  switch (step.kind) {
    case step_kind::import: {
      auto* body = message.mutable_import_mesh();
      set_terms(body, made, step);
      made.file = step.value % 11 == 0 ? "rubbish" : "part " + std::to_string(step.value % 4);
      body->set_size(made.file.size());
      body->set_file_name("part.msh");
      return made;
    }
    case step_kind::apply:
      set_terms(message.mutable_apply_edit(), made, step);
      message.mutable_apply_edit()->set_carry_over(step.value % 2 == 0);
      edit(message.mutable_apply_edit());
      return made;
    case step_kind::preview:
      message.mutable_preview_edit()->mutable_edit()->set_document(document_);
      edit(message.mutable_preview_edit()->mutable_edit());
      return made;
    case step_kind::undo:
      set_terms(message.mutable_undo(), made, step);
      return made;
    case step_kind::redo:
      set_terms(message.mutable_redo(), made, step);
      return made;
    case step_kind::go_to:
      set_terms(message.mutable_go_to_version(), made, step);
      message.mutable_go_to_version()->set_number(step.value % 6);
      return made;
    case step_kind::set_load_case:
      set_terms(message.mutable_set_load_case(), made, step);
      protocol::to_message(made_up_load_case(load_case, 1 + step.value % 100),
                           message.mutable_set_load_case()->mutable_load_case());
      return made;
    case step_kind::remove_load_case:
      set_terms(message.mutable_remove_load_case(), made, step);
      message.mutable_remove_load_case()->set_load_case(load_case);
      return made;
    case step_kind::annotate:
      set_terms(message.mutable_annotate_version(), made, step);
      message.mutable_annotate_version()->set_number(step.value % 4);
      message.mutable_annotate_version()->set_name("name " + std::to_string(step.value));
      return made;
    case step_kind::solve:
      message.mutable_solve()->set_document(document_);
      if (step.value % 2 == 0)
        message.mutable_solve()->set_load_case(load_case);
      return made;
    case step_kind::cancel_solve:
      message.mutable_cancel_solve()->set_document(document_);
      return made;
    case step_kind::cancel_last:
      message.mutable_cancel()->set_request_id(last_id_);
      return made;
    case step_kind::export_file:
      message.mutable_export_file()->set_document(document_);
      message.mutable_export_file()->set_format(step.value % 2 == 0 ? "vtu" : "msh");
      return made;
    case step_kind::rename:
      message.mutable_rename_document()->set_document(document_);
      message.mutable_rename_document()->set_name("e" + std::to_string(step.value % 3));
      return made;
    case step_kind::list_documents:
      message.mutable_list_documents();
      return made;
    case step_kind::copy_document:
      message.mutable_copy_document()->set_document(
        step.value % 4 == 0 ? name_of_copy(step.value / 12) : document_);
      message.mutable_copy_document()->set_name(name_of_copy(step.value));
      return made;
    case step_kind::delete_document:
      message.mutable_delete_document()->set_document(
        step.value % 4 == 0 ? document_ : name_of_copy(step.value));
      return made;
    case step_kind::compare: {
      auto* body = message.mutable_compare_versions();
      body->set_document(document_);
      body->set_before(step.value % 5);
      body->set_after(step.value / 5 % 5);
      if (step.value % 2 == 0)
        body->set_load_case(load_case);
      return made;
    }
    case step_kind::check_print:
      message.mutable_check_print()->set_document(document_);
      message.mutable_check_print()->set_thinner_than_m(1e-3 * (step.value % 5));
      if (step.value % 8 == 3)
        message.mutable_check_print()->set_version(step.value / 8 % 5);
      return made;
    case step_kind::history:
      message.mutable_get_history()->set_document(document_);
      return made;
    default:
      return std::nullopt;
  }
}

}  // namespace tedit::simulation
