// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/page.hpp"

namespace tedit::gateway {

/// Bytes of uploads that the server holds, of one connection or of all. Thread-safe.
class upload_account {
public:
  /// The account of all connections.
  explicit upload_account(std::uint64_t limit) : limit_(limit) {}
  /// The account of one connection, which is part of `all`.
  upload_account(std::uint64_t limit, std::shared_ptr<upload_account> all)
      : limit_(limit), all_(std::move(all)) {}

  /// Errors: `conflict` when this account or that of all connections would go over its limit; then
  /// nothing is taken.
  [[nodiscard]] expected<void> take(std::uint64_t bytes);
  void give_back(std::uint64_t bytes);

  [[nodiscard]] std::uint64_t used() const { return used_; }
  [[nodiscard]] std::uint64_t limit() const { return limit_; }

private:
  const std::uint64_t limit_;
  const std::shared_ptr<upload_account> all_;  ///< Null in the account of all.
  std::atomic<std::uint64_t> used_{0};
};

/// A file on its way to the server. Its bytes are on an account for as long as it or a copy of
/// `hold` lives: until it is imported, or the connection is gone.
class upload {
public:
  explicit upload(std::shared_ptr<upload_account> account)
      : hold_(std::make_shared<hold>(std::move(account))) {}

  /// Takes the next piece. Errors: `protocol_error` when one is missing; those of the account.
  [[nodiscard]] expected<void> append(std::uint64_t offset, const std::string& data);

  [[nodiscard]] std::uint64_t size() const { return hold_->bytes; }

  /// The whole file, cut into pages; it can be taken once.
  [[nodiscard]] std::vector<page_ptr> take_pages();

  /// What keeps the bytes on the account.
  [[nodiscard]] std::shared_ptr<const void> held() const { return hold_; }

private:
  struct hold {
    explicit hold(std::shared_ptr<upload_account> of) : account(std::move(of)) {}
    hold(const hold&) = delete;
    hold& operator=(const hold&) = delete;
    ~hold() { account->give_back(bytes); }

    std::shared_ptr<upload_account> account;
    std::uint64_t bytes = 0;
  };

  std::shared_ptr<hold> hold_;
  std::vector<page_ptr> pages_;
  std::string rest_;  ///< Less than a page.
};

}  // namespace tedit::gateway
