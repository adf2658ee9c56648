// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/error.hpp"

namespace tedit::store {

/// Keeps a document to one holder, here and in all processes, for as long as it lives; the kernel
/// ends it with the process. All documents of a folder share one descriptor: each locks one byte,
/// chosen by its name, of the folder's file `.tedit-lock`. Thread-safe.
class document_lock {
public:
  /// @param file absolute, without links.
  /// Errors: `conflict` when somebody holds it; `io_error` when the system refuses.
  [[nodiscard]] static expected<document_lock> take(const std::filesystem::path& file);

  /// Whether somebody holds it, here or elsewhere; takes and makes nothing. False, too, where that
  /// cannot be found out.
  [[nodiscard]] static bool held(const std::filesystem::path& file);

  document_lock() = default;  ///< Holds nothing.
  document_lock(document_lock&& other) noexcept = default;
  document_lock& operator=(document_lock&& other) noexcept;
  ~document_lock();

private:
  struct folder;

  void release() noexcept;

  std::shared_ptr<folder> folder_;
  std::string name_;
};

}  // namespace tedit::store
