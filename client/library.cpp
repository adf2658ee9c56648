// SPDX-License-Identifier: AGPL-3.0-or-later
// Requests about the documents of the server as a whole.
#include "client/impl.hpp"

namespace tedit::client {

expected<std::vector<document_info>> client::list_documents() {
  v1::ClientMessage request;
  request.mutable_list_documents();
  const auto got = impl_->ask(std::move(request), body::kDocumentList);
  if (!got)
    return fail(got.error());
  std::vector<document_info> result;
  for (const auto& one : got->message.document_list().documents())
    result.push_back(from_message(one));
  return result;
}

expected<void> client::copy_document(const std::string& document, const std::string& copy,
                                     const execution& run) {
  v1::ClientMessage request;
  request.mutable_copy_document()->set_document(document);
  request.mutable_copy_document()->set_name(copy);
  const auto got = impl_->ask(std::move(request), body::kDocumentAdded, run);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::rename_on_server(const std::string& document, const std::string& name) {
  v1::ClientMessage request;
  request.mutable_rename_document()->set_document(document);
  request.mutable_rename_document()->set_name(name);
  const auto got = impl_->ask(std::move(request), body::kDone);
  if (!got)
    return fail(got.error());
  return {};
}

expected<void> client::delete_document(const std::string& document) {
  v1::ClientMessage request;
  request.mutable_delete_document()->set_document(document);
  const auto got = impl_->ask(std::move(request), body::kDocumentDeleted);
  if (!got)
    return fail(got.error());
  const std::lock_guard lock(impl_->mutex);
  if (impl_->document == got->message.document_deleted().document())
    impl_->document.clear();
  return {};
}

}  // namespace tedit::client
