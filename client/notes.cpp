// SPDX-License-Identifier: AGPL-3.0-or-later
// Requests that make no new version.
#include "client/impl.hpp"
#include "protocol/load_case_message.hpp"

namespace tedit::client {

expected<void> client::set_load_case(const fem::load_case& loads, const change_terms& terms) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  request.mutable_set_load_case()->set_document(*document);
  protocol::to_message(loads, request.mutable_set_load_case()->mutable_load_case());
  set_terms(terms, *request.mutable_set_load_case());
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::remove_load_case(const std::string& name, const change_terms& terms) {
  auto document = impl_->open_document();
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
  auto document = impl_->open_document();
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
  auto document = impl_->open_document();
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
  auto document = impl_->open_document();
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

expected<std::string> client::watch_fields(const watched_quantities& wanted,
                                           std::uint64_t held_solve) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* watch = request.mutable_watch_fields();
  watch->set_document(*document);
  for (const auto& name : wanted)
    watch->add_quantities(name);
  watch->set_held_solve(held_solve);
  impl_->link.arrivals().forget_fields();
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return got->message.done().note();
}

}  // namespace tedit::client
