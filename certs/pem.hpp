// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "certs/authority.hpp"
#include "certs/openssl.hpp"

/// Keys, certificates and lists of revoked ones as PEM files, and what stands in them.
namespace tedit::certs {

/// The bytes of a file of at most a MiB. Errors: `io_error`; `bad_input` for a larger one.
[[nodiscard]] expected<std::string> read_small_file(const std::filesystem::path& file);

/// Errors of all four: those of `read_small_file`; `bad_input` for what is none, cut off or
/// followed by something else.
[[nodiscard]] expected<x509_ptr> read_certificate(const std::filesystem::path& file);
[[nodiscard]] expected<crl_ptr> read_revoked(const std::filesystem::path& file);
/// A certificate and those that lead from it to an authority, at least one.
[[nodiscard]] expected<std::vector<x509_ptr>> read_chain(const std::filesystem::path& file);
/// Also: `invalid_argument` when others may read the file, or a passphrase guards it.
[[nodiscard]] expected<key_ptr> read_key(const std::filesystem::path& file);

[[nodiscard]] std::string to_pem(X509& one);
[[nodiscard]] std::string to_pem(X509_CRL& one);
[[nodiscard]] std::string to_pem(EVP_PKEY& one);

/// What a certificate of ours says; not whether it holds. Errors: `bad_input` when the subject has
/// not exactly one name and one role that there is.
[[nodiscard]] expected<certificate> read_facts(X509& one);

/// The one CN of a subject; empty when there is none or more than one.
[[nodiscard]] std::string common_name(X509& one);

/// Names and addresses that it holds for.
[[nodiscard]] std::vector<std::string> hosts_of(X509& one);

/// Seconds since 1970.
[[nodiscard]] std::int64_t time_of(const ASN1_TIME* when);

/// As `certificate::serial`; longer for numbers of other authorities.
[[nodiscard]] std::string serial_text(const ASN1_INTEGER* number);

[[nodiscard]] list_facts facts_of(X509_CRL& list);

/// The serials on the list.
[[nodiscard]] std::set<std::string> serials_of(X509_CRL& list);

}  // namespace tedit::certs
