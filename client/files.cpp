// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that go to the server and come from it.
#include <algorithm>
#include <fstream>
#include <system_error>

#include "base/text.hpp"
#include "client/impl.hpp"

namespace tedit::client {

namespace {

struct open_file {
  std::ifstream bytes;
  std::uint64_t size = 0;
};

/// Errors: `io_error`; `bad_input` for an empty file.
expected<open_file> open_to_send(const std::filesystem::path& path) {
  std::error_code code;
  open_file result{std::ifstream(path, std::ios::binary), std::filesystem::file_size(path, code)};
  if (code || !result.bytes)
    return fail(ec::io_error, "the file cannot be read" + (code ? ": " + code.message() : ""), {},
                path.string());
  if (result.size == 0)
    return fail(ec::bad_input, "the file is empty", {}, path.string());
  return result;
}

}  // namespace

/// The pieces of an upload, without what is asked of it. `first_id` is the first one's.
expected<void> client::impl::send_pieces(std::ifstream& file, std::uint64_t size,
                                         std::uint64_t upload, std::uint64_t first_id,
                                         const execution& run) {
  const auto step = piece();
  for (std::uint64_t offset = 0; offset < size; offset += step) {
    std::string data(std::min(step, size - offset), '\0');
    if (!file.read(data.data(), static_cast<std::streamsize>(data.size())))
      return fail(ec::io_error,
                  "the file ends or cannot be read near byte " + std::to_string(offset));
    v1::ClientMessage message;
    auto* chunk = message.mutable_upload_chunk();
    chunk->set_upload(upload);
    chunk->set_offset(offset);
    chunk->set_data(std::move(data));
    if (auto ok = link.send_unanswered(first_id, first_id + offset / step, std::move(message),
                                       options.request_timeout, run);
        !ok)
      return ok;
  }
  return {};
}

/// Sends the file as this upload, then what is asked of it.
expected<connection::answer> client::impl::ask_with_file(std::ifstream& file, std::uint64_t size,
                                                         std::uint64_t upload,
                                                         v1::ClientMessage request,
                                                         body::BodyCase wanted,
                                                         const execution& run) {
  run.report(0, "uploading");
  const auto first_id = link.begin_unanswered((size + piece() - 1) / piece());
  if (auto sent = send_pieces(file, size, upload, first_id, run); !sent) {
    (void)link.end_unanswered(first_id);
    return fail(std::move(sent.error()));
  }
  auto got = ask(std::move(request), wanted, run);
  // A piece that was refused is the reason for the failure.
  if (auto refused = link.end_unanswered(first_id); refused && !got)
    return fail(std::move(*refused));
  return got;
}

std::vector<offered_format> usual_formats() {
  std::vector<offered_format> result;
  for (const auto& format : file_formats)
    result.push_back({std::string(format.name), std::string(format.title), format.reads,
                      format.writes, format.keeps});
  return result;
}

expected<void> check_format(const std::vector<offered_format>& offered, const std::string& name) {
  std::vector<std::string_view> known;
  for (const auto& format : offered)
    if (format.writes)
      known.push_back(format.name);
  known.push_back(document_format);
  if (std::ranges::find(known, name) == known.end())
    return fail(no_such_format(name, known));
  return {};
}

expected<committed> client::import_file(const std::filesystem::path& path, const std::string& unit,
                                        const execution& run, const change_terms& terms) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  auto file = open_to_send(path);
  if (!file)
    return fail(std::move(file.error()));
  v1::ClientMessage request;
  auto* import = request.mutable_import_mesh();
  import->set_document(*document);
  import->set_file_name(path.filename().string());
  import->set_length_unit(unit);
  import->set_upload(impl_->next_upload++);
  import->set_size(file->size);
  set_terms(terms, *import);
  const auto got =
    impl_->ask_with_file(file->bytes, file->size, import->upload(), request, body::kCommitted, run);
  if (!got)
    return fail(got.error());
  return from_message(got->message.committed());
}

expected<connection::answer> client::impl::ask_for_document(v1::ClientMessage request,
                                                            const std::filesystem::path& path,
                                                            const execution& run) {
  auto file = open_to_send(path);
  if (!file)
    return fail(std::move(file.error()));
  const auto upload = next_upload++;
  const auto say = [&](auto& body) {
    body.set_upload(upload);
    body.set_size(file->size);
  };
  if (request.has_import_part())
    say(*request.mutable_import_part());
  else
    say(*request.mutable_add_document());
  return ask_with_file(file->bytes, file->size, upload, std::move(request), body::kDocumentAdded,
                       run);
}

expected<std::string> client::add_document(const std::filesystem::path& path,
                                           const std::string& name, bool or_next_free,
                                           const execution& run) {
  v1::ClientMessage request;
  auto* add = request.mutable_add_document();
  add->set_name(name);
  add->set_or_next_free(or_next_free);
  const auto got = impl_->ask_for_document(std::move(request), path, run);
  if (!got)
    return fail(got.error());
  return got->message.document_added().document();
}

expected<added_part> client::import_part(const std::filesystem::path& path, const std::string& name,
                                         const part_options& options, const execution& run) {
  v1::ClientMessage request;
  auto* part = request.mutable_import_part();
  part->set_name(name);
  part->set_or_next_free(options.or_next_free);
  part->set_file_name(to_utf8(path.filename().string()));
  part->set_fineness(options.fineness);
  part->set_length_unit(options.length_unit);
  for (const auto& one : options.local_sizes) {
    auto* size = part->add_local_sizes();
    size->set_surface(one.surface);
    size->set_edge_length(one.edge_length);
  }
  const auto got = impl_->ask_for_document(std::move(request), path, run);
  if (!got)
    return fail(got.error());
  const auto& added = got->message.document_added();
  return added_part{added.document(), {added.warnings().begin(), added.warnings().end()}};
}

std::vector<offered_format> client::formats() const {
  return impl_->link.formats();
}

std::string client::server_program() const {
  return impl_->link.server();
}

expected<std::vector<char>> client::export_file(const std::string& format,
                                                const std::string& version_id,
                                                const std::string& unit, const execution& run,
                                                const std::string& load_case) {
  auto document = impl_->open_document();
  if (!document)
    return fail(std::move(document.error()));
  v1::ClientMessage request;
  auto* wanted = request.mutable_export_file();
  wanted->set_document(*document);
  wanted->set_version_id(version_id);
  wanted->set_format(format);
  wanted->set_length_unit(unit);
  wanted->set_load_case(load_case);
  auto got = impl_->ask(std::move(request), body::kFileReady, run);
  if (!got)
    return fail(std::move(got.error()));
  return got->bulk->bytes("file");
}

}  // namespace tedit::client
