// SPDX-License-Identifier: AGPL-3.0-or-later
// Requests that make no new version.
#include <algorithm>

#include "client/impl.hpp"
#include "protocol/convert.hpp"
#include "protocol/json.hpp"

namespace tedit::client {

namespace {

/// What a server makes of a load that it does not know is another load: it leaves a gradient out.
unsigned minor_that_knows(const fem::load_case& loads) {
  const bool gradient = std::ranges::any_of(loads.loads, [](const fem::load& item) {
    const auto* p = std::get_if<fem::pressure>(&item.kind);
    return p && p->gradient_pa_m != vec3{};
  });
  const bool newer = std::ranges::any_of(loads.loads, [](const fem::load& item) {
    return std::holds_alternative<fem::normal_force>(item.kind) ||
           std::holds_alternative<fem::moment>(item.kind) ||
           std::holds_alternative<fem::remote_force>(item.kind) ||
           std::holds_alternative<fem::bearing_force>(item.kind);
  });
  return gradient || newer ? minor_of_spread_loads : 0;
}

}  // namespace

expected<void> client::set_load_case(const fem::load_case& loads, const change_terms& terms) {
  auto document =
    impl_->open_document(minor_that_knows(loads), "know a load of this load case", terms);
  if (!document)
    return fail(std::move(document.error()));
  auto message = protocol::message_from_json<v1::LoadCase>(protocol::load_case_to_json(loads));
  if (!message)
    return fail(std::move(message.error()));
  v1::ClientMessage request;
  request.mutable_set_load_case()->set_document(*document);
  *request.mutable_set_load_case()->mutable_load_case() = std::move(*message);
  set_terms(terms, *request.mutable_set_load_case());
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::remove_load_case(const std::string& name, const change_terms& terms) {
  auto document = impl_->open_document(5, "remove a load case", terms);
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_remove_load_case()->set_document(*document);
  request.mutable_remove_load_case()->set_load_case(name);
  set_terms(terms, *request.mutable_remove_load_case());
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::cancel_solve() {
  auto document = impl_->open_document(6, "end a solve that it began by itself");
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_cancel_solve()->set_document(*document);
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::annotate(std::uint32_t number, const std::string& name,
                                const std::string& note, const change_terms& terms) {
  auto document = impl_->open_document(5, "name versions");
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* wanted = request.mutable_annotate_version();
  wanted->set_document(*document);
  wanted->set_number(number);
  wanted->set_name(name);
  wanted->set_note(note);
  wanted->set_edit_id(terms.edit_id);
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::rename_document(const std::string& name, const std::string& before) {
  auto document = impl_->open_document(minor_of_documents, "rename documents");
  if (!document)
    return fail(std::move(document.error()));
  if (!before.empty() && *document != before)
    return fail(ec::conflict, "the open document is " + *document + ", not " + before,
                "Look at its name, then ask again");
  v1::ClientMessage request;
  request.mutable_rename_document()->set_document(*document);
  request.mutable_rename_document()->set_name(name);
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<std::string> client::watch_fields(const watched_quantities& wanted) {
  auto document = impl_->open_document(5, "send more than displacement and von Mises stress");
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* watch = request.mutable_watch_fields();
  watch->set_document(*document);
  if (wanted.stress)
    watch->add_quantities(v1::WatchFields::STRESS);
  if (wanted.safety_factor)
    watch->add_quantities(v1::WatchFields::SAFETY_FACTOR);
  if (wanted.relative_error)
    watch->add_quantities(v1::WatchFields::RELATIVE_ERROR);
  impl_->link.arrivals().forget_fields();
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return got->message.done().note();
}

}  // namespace tedit::client
