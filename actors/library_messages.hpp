// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <caf/actor.hpp>
#include <caf/allowed_unsafe_message_type.hpp>

#include "base/execution.hpp"

/// What is said about whole documents: copies, deletions and lists; within one process, as the
/// messages of actors/local_messages.hpp.
namespace tedit::actors {

/// A document of this name gets a copy of another one, open or not.
struct copy_request {
  std::string document;
  std::string name;
  cancel_token stop = {};
};

/// The same for the session of one that is open, its store and a disk.
struct copy_order {
  std::string name;
  cancel_token stop = {};
};

/// The same for a disk, of a document that nobody has open.
struct file_copy {
  std::filesystem::path from;
  std::filesystem::path to;
  cancel_token stop = {};
};

/// A document is to go for good; only who asks may have it open.
struct delete_request {
  std::string document;
  caf::actor asker;
};

/// The same for a disk, of a document that nobody has open.
struct deletion {
  std::filesystem::path file;
};

/// The name of a document that is gone.
struct deleted_document {
  std::string name;
};

/// A folder of documents whose files a disk is to look at, from outside.
struct folder_query {
  std::filesystem::path folder;
};

/// A document of the server.
struct document_row {
  std::string name;
  std::int64_t bytes = 0;    ///< Of its file, with the log; 0 while it has none.
  std::int64_t changed = 0;  ///< Seconds since 1970, UTC; 0 while it has no file.
  bool open = false;
  std::size_t clients = 0;              ///< That have it open.
  std::optional<std::size_t> versions;  ///< Of an open one.
  std::optional<std::uint32_t> head;    ///< Its number, of an open one that has any.
};

/// Documents by their names.
struct document_list {
  std::vector<document_row> documents;
};

/// How an open document stands.
struct session_status {
  std::size_t clients = 0;  ///< That have it open.
  std::size_t versions = 0;
  std::optional<std::uint32_t> head;  ///< Its number.
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::copy_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::copy_order)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::file_copy)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::delete_request)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::deletion)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::deleted_document)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::folder_query)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::document_list)
CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::session_status)
