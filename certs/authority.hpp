// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "certs/role.hpp"

/// A small certificate authority in a folder: who may be a node of a server says the owner of that
/// folder, and nobody else. Keys are EC P-256, files 0600, folders 0700.
///
/// The authority's folder holds `ca.crt`, `ca.key`, `crl.pem` (what was revoked; that file alone
/// says so) and `issued/SERIAL.crt`. What a node needs is a folder of its own: `node.key`,
/// `node.crt`, `ca.crt`, and for a server `crl.pem`. Each folder appears whole or not at all, and
/// each file in it is replaced in one step; two calls at once take turns.
///
/// Common errors of all functions: `io_error`; `bad_input` for a file that is cut off or no
/// certificate, key or list, naming it; `invalid_argument` for a key that others may read.
/// Cost: a few milliseconds and an fsync for each file; `list` reads each certificate.
namespace tedit::certs {

using seconds = std::chrono::seconds;

inline constexpr seconds day = std::chrono::hours(24);
inline constexpr seconds authority_days = 3650 * day;
inline constexpr seconds node_days = 365 * day;

/// Names of the files; docs/decisions/0036 has what is in which folder.
inline constexpr auto authority_certificate_file = "ca.crt";
inline constexpr auto authority_key_file = "ca.key";
inline constexpr auto revoked_file = "crl.pem";
inline constexpr auto node_certificate_file = "node.crt";
inline constexpr auto node_key_file = "node.key";

/// A certificate as people see it.
struct certificate {
  std::string name;
  role what = role::client;
  std::string serial;              ///< 16 hexadecimal digits.
  std::vector<std::string> hosts;  ///< Names and addresses that it holds for, its name among them.
  std::int64_t from = 0;           ///< Seconds since 1970, as is `until`.
  std::int64_t until = 0;
  bool revoked = false;
};

/// All of an authority.
struct listing {
  std::string name;
  std::int64_t until = 0;
  std::vector<certificate> certificates;  ///< By name, then by their end.
};

/// What a list of revoked certificates says of itself.
struct list_facts {
  std::int64_t number = 0;  ///< Each new one of an authority has a higher one; 0: it has none.
  std::int64_t from = 0;    ///< Seconds since 1970, as is `until`.
  std::int64_t until = 0;   ///< When a newer one should be there; 0: it does not say.

  [[nodiscard]] bool is_overdue(std::int64_t now) const { return until != 0 && until <= now; }
};

/// What a new certificate shall say.
struct order {
  role what = role::client;
  std::string name;                ///< Up to 63 letters, digits, ".", "-" and "_".
  std::vector<std::string> hosts;  ///< Host names and IP addresses, beside its name.
  seconds valid = node_days;
  std::optional<std::int64_t> from = {};  ///< Seconds since 1970; an hour ago without it.
};

/// Makes an authority in `folder`, which must not be there or be empty.
/// Errors: `conflict` when something is in it; `invalid_argument` for a name that cannot be one.
[[nodiscard]] expected<listing> init(const std::filesystem::path& folder,
                                     const std::string& name = "TEdit",
                                     seconds valid = authority_days);

/// Makes a key and a certificate, and with the authority's certificate puts them into `out`, which
/// must not be there or be empty.
/// Errors: `conflict` when `out` holds something or the name has a certificate that holds;
/// `invalid_argument` for a name, host or time that cannot be, as one beyond the authority's end.
[[nodiscard]] expected<certificate> issue(const std::filesystem::path& folder, const order& what,
                                          const std::filesystem::path& out);

/// A new key and certificate of the same name, role and hosts as the name's last one, which stays
/// as it is. Where `out` holds the files of a certificate of that name from this authority, they
/// are exchanged in one step.
/// Errors: `not_found` when the name has none; `conflict` when its last one was revoked, or `out`
/// holds anything else.
[[nodiscard]] expected<certificate> renew(const std::filesystem::path& folder,
                                          const std::string& name, seconds valid,
                                          const std::filesystem::path& out);

/// Whom `revoke` means.
struct revocation {
  std::string name;    ///< All of its certificates that have not ended.
  std::string serial;  ///< Or this one.
};

/// Puts certificates on the list of those that hold no longer, and gives them. Who is there
/// already stays there, and is not given again.
/// Errors: `not_found` when there is no such certificate; `conflict` when nothing was left to do.
[[nodiscard]] expected<std::vector<certificate>> revoke(const std::filesystem::path& folder,
                                                        const revocation& whom);

[[nodiscard]] expected<listing> list(const std::filesystem::path& folder);

}  // namespace tedit::certs
