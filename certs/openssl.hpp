// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/x509.h>

/// Owners of OpenSSL's objects; for sources that speak with that library, not for headers.
namespace tedit::certs {

template <auto Free>
struct openssl_end {
  template <class T>
  void operator()(T* one) const noexcept {
    Free(one);
  }
};

using bio_ptr = std::unique_ptr<BIO, openssl_end<BIO_free>>;
using key_ptr = std::unique_ptr<EVP_PKEY, openssl_end<EVP_PKEY_free>>;
using x509_ptr = std::unique_ptr<X509, openssl_end<X509_free>>;
using crl_ptr = std::unique_ptr<X509_CRL, openssl_end<X509_CRL_free>>;

/// The last thing that OpenSSL complained of, which is forgotten then.
[[nodiscard]] std::string openssl_complaint();

}  // namespace tedit::certs
