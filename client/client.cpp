// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/client.hpp"

#include <algorithm>
#include <cstdio>
#include <random>

#include "client/impl.hpp"
#include "protocol/convert.hpp"
#include "protocol/json.hpp"
#include "protocol/load_policy_message.hpp"
#include "protocol/operation_message.hpp"
#include "protocol/selection_message.hpp"
#include "protocol/vector_message.hpp"

namespace tedit::client {

namespace {

/// The answer as the caller's data; `get` is the accessor of its body.
template <class Body>
auto convert(const expected<connection::answer>& got, const Body& (v1::ServerMessage::*get)() const)
  -> expected<decltype(from_message(std::declval<const Body&>()))> {
  if (!got)
    return fail(got.error());
  return from_message((got->message.*get)());
}

}  // namespace

// -- the connection ------------------------------------------------------------------

client::client(std::unique_ptr<impl> made) : impl_(std::move(made)) {}

client::~client() = default;

expected<std::unique_ptr<client>> client::connect(const connect_options& options, events handlers) {
  auto made = std::make_unique<impl>(options, std::move(handlers));
  if (auto ok = made->link.start(options); !ok)
    return fail(std::move(ok.error()));
  return std::unique_ptr<client>(new client(std::move(made)));
}

bool client::connected() const noexcept {
  return impl_->link.connected();
}

own_access client::access() const {
  return impl_->link.access();
}

std::string make_edit_id() {
  std::random_device source;
  std::string id;
  for (int i = 0; i < 4; ++i) {
    char digits[16];
    std::snprintf(digits, sizeof(digits), "%08x", static_cast<unsigned>(source()));
    id += digits;
  }
  return id;
}

void client::abort() {
  impl_->link.abort();
}

expected<operation_catalogue> client::operations() {
  v1::ClientMessage request;
  request.mutable_list_operations();
  const auto got = impl_->ask(std::move(request), body::kCatalogue);
  if (!got)
    return fail(got.error());
  return protocol::from_message(got->message.catalogue());
}

expected<server_status> client::status() {
  v1::ClientMessage request;
  request.mutable_get_status();
  return convert(impl_->ask(std::move(request), body::kServerStatus), &body::server_status);
}

// -- the document --------------------------------------------------------------------

expected<void> client::impl::close_document() {
  v1::ClientMessage request;
  {
    const std::lock_guard lock(mutex);
    if (document.empty())
      return {};
    request.mutable_close_document()->set_document(document);
    document.clear();
  }
  const auto got = ask(std::move(request), body::kDone);
  if (!got && got.error().code != ec::not_found)
    return fail(got.error());
  return {};
}

expected<document_state> client::open(const std::string& name, bool watch_surface,
                                      bool watch_fields, const surface_model& held) {
  if (auto ok = impl_->close_document(); !ok)
    return fail(std::move(ok.error()));
  impl_->link.arrivals().open(name, held);
  v1::ClientMessage request;
  auto* open = request.mutable_open_document();
  open->set_name(name);
  open->set_watch_surface(watch_surface);
  open->set_watch_fields(watch_fields);
  open->set_held_version_id(held.version_id());
  auto state = convert(impl_->ask(std::move(request), body::kDocumentState), &body::document_state);
  if (state) {
    const std::lock_guard lock(impl_->mutex);
    // It may have been renamed since the answer came.
    impl_->document = state->document = impl_->link.arrivals().document();
  }
  return state;
}

expected<void> client::close_document() {
  return impl_->close_document();
}

/// The message ApplyEdit for the open document. Errors: `invalid_argument` when none is open.
expected<v1::ApplyEdit> client::impl::describe_edit(const std::string& operation,
                                                    const std::vector<surface_id>& surfaces,
                                                    const ops::parameters& values,
                                                    const std::string& expected_version,
                                                    const fem::carry_settings& loads) {
  auto name = open_document();
  if (!name)
    return fail(std::move(name.error()));
  v1::ApplyEdit edit;
  protocol::to_message({operation, surfaces, values, loads}, &edit);
  edit.set_document(*name);
  edit.set_expected_version(expected_version);
  return edit;
}

expected<committed> client::edit(const std::string& operation,
                                 const std::vector<surface_id>& surfaces,
                                 const ops::parameters& values, const execution& run,
                                 const std::string& expected_version,
                                 const fem::carry_settings& loads, const std::string& edit_id,
                                 bool carry_over) {
  auto edit = impl_->describe_edit(operation, surfaces, values, expected_version, loads);
  if (!edit)
    return fail(std::move(edit.error()));
  edit->set_edit_id(edit_id);
  edit->set_carry_over(carry_over);
  v1::ClientMessage request;
  *request.mutable_apply_edit() = std::move(*edit);
  return convert(impl_->ask(std::move(request), body::kCommitted, run), &body::committed);
}

expected<edit_preview> client::preview_edit(const std::string& operation,
                                            const std::vector<surface_id>& surfaces,
                                            const ops::parameters& values, const execution& run,
                                            const std::string& expected_version,
                                            const fem::carry_settings& loads, preview_kind kind) {
  auto edit = impl_->describe_edit(operation, surfaces, values, expected_version, loads);
  if (!edit)
    return fail(std::move(edit.error()));
  v1::ClientMessage request;
  *request.mutable_preview_edit()->mutable_edit() = std::move(*edit);
  request.mutable_preview_edit()->set_find_most(kind == preview_kind::whole_or_most);
  request.mutable_preview_edit()->set_draft(kind == preview_kind::draft);
  auto got = impl_->ask(std::move(request), body::kEditPreview, run);
  if (!got)
    return fail(std::move(got.error()));
  return read_preview(got->message.edit_preview(), *got->bulk);
}

expected<surface_model> client::surface_of(std::uint32_t number, const execution& run) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_get_surface()->set_document(*document);
  request.mutable_get_surface()->set_number(number);
  auto got = impl_->ask(std::move(request), body::kVersionSurface, run);
  if (!got)
    return fail(std::move(got.error()));
  const auto update = read_surface(got->message.version_surface().surface(), *got->bulk);
  surface_model result;
  auto taken = update ? result.apply(*update) : fail(update.error());
  return taken ? expected<surface_model>(std::move(result)) : fail(std::move(taken.error()));
}

expected<committed> client::undo(const change_terms& terms) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_undo()->set_document(*document);
  set_terms(terms, *request.mutable_undo());
  return convert(impl_->ask(std::move(request), body::kCommitted), &body::committed);
}

expected<committed> client::redo(const change_terms& terms) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_redo()->set_document(*document);
  set_terms(terms, *request.mutable_redo());
  return convert(impl_->ask(std::move(request), body::kCommitted), &body::committed);
}

expected<committed> client::go_to(std::uint32_t number, const change_terms& terms) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_go_to_version()->set_document(*document);
  request.mutable_go_to_version()->set_number(number);
  set_terms(terms, *request.mutable_go_to_version());
  return convert(impl_->ask(std::move(request), body::kCommitted), &body::committed);
}

expected<section> client::cut(const vec3& at, const vec3& normal, const std::string& load_case,
                              const execution& run) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* wanted = request.mutable_cut_section();
  wanted->set_document(*document);
  wanted->set_load_case(load_case);
  protocol::write_vector(at, wanted->mutable_point_m());
  protocol::write_vector(normal, wanted->mutable_normal());
  auto got = impl_->ask(std::move(request), body::kSectionReady, run);
  if (!got)
    return fail(std::move(got.error()));
  return read_section(got->message.section_ready(), *got->bulk);
}

expected<solve_report> client::solve(const solve_settings& settings, const execution& run) {
  return solve_cases(settings, run).map([](const solve_outcome& outcome) {
    return outcome.cases.front();
  });
}

expected<solve_outcome> client::solve_cases(const solve_settings& settings, const execution& run) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* solve = request.mutable_solve();
  solve->set_document(*document);
  solve->set_load_case(settings.load_case);
  solve->set_tolerance(settings.tolerance);
  solve->set_device(settings.device);
  solve->set_element_order(static_cast<std::uint32_t>(settings.element_order));
  solve->mutable_load_cases()->Assign(settings.load_cases.begin(), settings.load_cases.end());
  solve->set_all_load_cases(settings.all_load_cases);
  solve->set_energy_tolerance(settings.energy_tolerance);
  solve->set_held_solve(settings.held_solve);
  impl_->link.arrivals().forget_fields();
  const auto got = impl_->ask(std::move(request), body::kSolved, run);
  if (!got)
    return fail(got.error());
  auto outcome = protocol::from_message(got->message.solved());
  return outcome;
}

expected<std::vector<found_feature>> client::select(const selection_query& query,
                                                    const execution& run) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* wanted = request.mutable_select_surfaces();
  protocol::to_message(query, wanted);
  wanted->set_document(*document);
  auto got = impl_->ask(std::move(request), body::kSurfacesSelected, run);
  if (!got)
    return fail(std::move(got.error()));
  return protocol::from_message(got->message.surfaces_selected());
}

expected<history> client::get_history(bool reports) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_get_history()->set_document(*document);
  request.mutable_get_history()->set_reports(reports);
  return convert(impl_->ask(std::move(request), body::kHistory), &body::history);
}

// -- what is sent unasked ----------------------------------------------------------------

expected<surface_event> client::wait_surface(const std::string& version_id,
                                             std::chrono::milliseconds patience) {
  if (impl_->link.on_io_thread())
    return fail(ec::internal, "a blocking call from one of the client's own events");
  return impl_->link.arrivals().wait_surface(version_id, patience);
}

expected<std::vector<field_event>> client::wait_fields(const std::string& version_id,
                                                       std::chrono::milliseconds patience,
                                                       std::uint64_t solve) {
  if (impl_->link.on_io_thread())
    return fail(ec::internal, "a blocking call from one of the client's own events");
  auto arrived = impl_->link.arrivals().wait_fields(version_id, solve, patience);
  return arrived.map([](const auto& fields) {
    std::vector<field_event> copies;
    for (const auto& field : fields)
      copies.push_back(*field);
    return copies;
  });
}

expected<field_event> client::wait_field(const std::string& version_id,
                                         std::chrono::milliseconds patience) {
  if (impl_->link.on_io_thread())
    return fail(ec::internal, "a blocking call from one of the client's own events");
  return impl_->link.arrivals().wait_fields(version_id, 0, patience).map([](const auto& fields) {
    return *fields.back();
  });
}

surface_model client::surface() const {
  return impl_->link.arrivals().surface();
}

}  // namespace tedit::client
