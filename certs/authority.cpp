// SPDX-License-Identifier: AGPL-3.0-or-later
#include "certs/authority.hpp"

#include <algorithm>
#include <cctype>
#include <tuple>

#include <openssl/x509v3.h>

#include "base/text.hpp"
#include "base/utc.hpp"
#include "certs/folders.hpp"
#include "certs/make.hpp"
#include "certs/pem.hpp"

namespace tedit::certs {

namespace {

namespace fs = std::filesystem;

constexpr auto issued_folder = "issued";
constexpr std::size_t most_letters = 63;

/// An authority that can sign: certificate and key that belong together, and its list.
struct signer {
  identity own;
  crl_ptr revoked;
};

/// An authority as long as nobody else changes it.
struct held_authority {
  unique_fd lock;
  signer by;
  listing known;
};

bool is_name(const std::string& text) {
  const auto fits = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_';
  };
  return !text.empty() && text.size() <= most_letters &&
         std::isalnum(static_cast<unsigned char>(text.front())) != 0 &&
         std::ranges::all_of(text, fits);
}

bool is_address(const std::string& text) {
  using octets_ptr = std::unique_ptr<ASN1_OCTET_STRING, openssl_end<ASN1_OCTET_STRING_free>>;
  return octets_ptr(a2i_IPADDRESS(text.c_str())) != nullptr;
}

expected<void> check_authority_name(const std::string& name) {
  const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (name.empty() || name.size() > most_letters || !is_utf8(name) ||
      std::ranges::any_of(name, control))
    return fail(ec::invalid_argument, "\"" + name + "\" cannot be the name of an authority",
                "Give up to 63 letters");
  return {};
}

expected<void> check_valid(seconds valid, std::int64_t from, std::int64_t limit) {
  if (valid < seconds(1))
    return fail(ec::invalid_argument, "a certificate must hold for a while",
                "Give a number of days from 1");
  if (from + valid.count() > limit)
    return fail(ec::invalid_argument,
                "the certificate would hold beyond its authority, which ends at " + utc_text(limit),
                "At most " +
                  std::to_string(std::max<std::int64_t>(0, (limit - from) / day.count())) +
                  " days are left; make a new authority in time");
  return {};
}

expected<void> check_order(const order& what, const listing& authority) {
  if (!is_name(what.name))
    return fail(ec::invalid_argument, "\"" + what.name + "\" cannot be the name of a node",
                "Give up to 63 letters, digits, \".\", \"-\" and \"_\"");
  for (const auto& host : what.hosts)
    if (!is_name(host) && !is_address(host))
      return fail(ec::invalid_argument, "\"" + host + "\" is no host name and no IP address",
                  "Name each host: there are no wildcards, ports or addresses of networks");
  return check_valid(what.valid, what.from.value_or(now_s()), authority.until);
}

expected<x509_ptr> authority_certificate(const fs::path& folder) {
  std::error_code code;
  if (!fs::exists(folder / authority_certificate_file, code) ||
      !fs::is_directory(folder / issued_folder, code))
    return fail(ec::not_found, folder.string() + " holds no authority",
                "Make one: tedit certs init " + folder.string());
  return read_certificate(folder / authority_certificate_file);
}

expected<crl_ptr> read_own_list(const fs::path& folder, X509& authority) {
  auto list = read_revoked(folder / revoked_file);
  if (list && X509_CRL_verify(list->get(), X509_get0_pubkey(&authority)) != 1) {
    static_cast<void>(openssl_complaint());
    return fail(ec::bad_input, (folder / revoked_file).string() + " is of another authority",
                "Restore it from a backup: without it revoked certificates would hold again");
  }
  return list;
}

expected<signer> read_signer(const fs::path& folder) {
  signer result;
  auto certificate = authority_certificate(folder);
  if (!certificate)
    return fail(certificate.error());
  auto key = read_key(folder / authority_key_file);
  if (!key)
    return fail(key.error());
  if (X509_check_private_key(certificate->get(), key->get()) != 1) {
    static_cast<void>(openssl_complaint());
    return fail(
      ec::bad_input,
      (folder / authority_key_file).string() + " does not belong to " + authority_certificate_file,
      "Restore both from one backup");
  }
  auto list = read_own_list(folder, **certificate);
  if (!list)
    return fail(list.error());
  result.own = {std::move(*certificate), std::move(*key)};
  result.revoked = std::move(*list);
  return result;
}

/// The key, the certificate and the authority's; for a server the list, too.
expected<void> fill_node_folder(const fs::path& draft, const signer& by, const identity& node,
                                role what) {
  return write_new(draft / node_key_file, to_pem(*node.key))
    .and_then([&] { return write_new(draft / node_certificate_file, to_pem(*node.certificate)); })
    .and_then(
      [&] { return write_new(draft / authority_certificate_file, to_pem(*by.own.certificate)); })
    .and_then([&]() -> expected<void> {
      if (what != role::server)
        return {};
      return write_new(draft / revoked_file, to_pem(*by.revoked));
    });
}

/// The record comes first: a certificate that is somewhere and not on the list could not be
/// revoked.
expected<certificate> hand_out(const fs::path& folder, const signer& by, const order& what,
                               expected<folder_draft> draft) {
  if (!draft)
    return fail(draft.error());
  const auto node = make_node(by.own, what);
  if (!node)
    return fail(node.error());
  auto facts = read_facts(*node->certificate);
  if (!facts)
    return facts;
  const auto record = folder / issued_folder / (facts->serial + ".crt");
  const auto done = fill_node_folder(draft->path(), by, *node, what.what)
                      .and_then([&] { return replace_file(record, to_pem(*node->certificate)); })
                      .and_then([&] { return draft->put_in_place(); });
  if (!done) {
    std::error_code ignored;
    fs::remove(record, ignored);
    return fail(done.error());
  }
  return facts;
}

/// Whether `out` has nothing but the files of a node of this name and authority.
bool is_folder_of(const fs::path& out, const std::string& name, X509& authority) {
  std::error_code code;
  for (fs::directory_iterator entry(out, code), end; !code && entry != end; entry.increment(code)) {
    const auto file = entry->path().filename().string();
    if (file != node_key_file && file != node_certificate_file &&
        file != authority_certificate_file && file != revoked_file)
      return false;
  }
  const auto there = code ? expected<x509_ptr>(fail(ec::io_error, ""))
                          : read_certificate(out / node_certificate_file);
  const bool same = there && common_name(**there) == name &&
                    X509_verify(there->get(), X509_get0_pubkey(&authority)) == 1;
  static_cast<void>(openssl_complaint());
  return same;
}

expected<held_authority> hold(const fs::path& folder) {
  if (const auto there = authority_certificate(folder); !there)
    return fail(there.error());
  auto lock = lock_folder(folder);
  if (!lock)
    return fail(lock.error());
  auto by = read_signer(folder);
  if (!by)
    return fail(by.error());
  auto known = list(folder);
  if (!known)
    return fail(known.error());
  return held_authority{std::move(*lock), std::move(*by), std::move(*known)};
}

}  // namespace

expected<listing> init(const fs::path& folder, const std::string& name, seconds valid) {
  if (auto ok = check_authority_name(name); !ok)
    return fail(ok.error());
  if (valid < day || valid > 2 * authority_days)
    return fail(ec::invalid_argument, "an authority cannot hold for so long",
                "Give 1 to 7300 days");
  auto draft = folder_draft::make(folder);
  if (!draft)
    return fail(draft.error());
  const auto own = make_authority(name, valid);
  if (!own)
    return fail(own.error());
  const auto list = make_revoked(*own, nullptr, {});
  if (!list)
    return fail(list.error());
  std::error_code code;
  fs::create_directory(draft->path() / issued_folder, code);
  fs::permissions(draft->path() / issued_folder, fs::perms::owner_all, code);
  const auto done =
    write_new(draft->path() / authority_key_file, to_pem(*own->key))
      .and_then([&] {
        return write_new(draft->path() / authority_certificate_file, to_pem(*own->certificate));
      })
      .and_then([&] { return write_new(draft->path() / revoked_file, to_pem(**list)); })
      .and_then([&] { return draft->put_in_place(); });
  if (!done)
    return fail(done.error());
  return listing{name, time_of(X509_get0_notAfter(own->certificate.get())), {}};
}

expected<listing> list(const fs::path& folder) {
  const auto own = authority_certificate(folder);
  if (!own)
    return fail(own.error());
  const auto revoked = read_own_list(folder, **own);
  if (!revoked)
    return fail(revoked.error());
  const auto serials = serials_of(**revoked);
  listing result{common_name(**own), time_of(X509_get0_notAfter(own->get())), {}};
  std::error_code code;
  for (fs::directory_iterator entry(folder / issued_folder, code), end; !code && entry != end;
       entry.increment(code)) {
    if (entry->path().filename().string().starts_with('.'))
      continue;  // What a kill left of a record.
    const auto one = read_certificate(entry->path());
    auto facts = one ? read_facts(**one) : expected<certificate>(fail(one.error()));
    if (!facts)
      return fail(facts.error());
    facts->revoked = serials.contains(facts->serial);
    result.certificates.push_back(std::move(*facts));
  }
  if (code)
    return fail(ec::io_error, "cannot list " + folder.string() + ": " + code.message(),
                "Check the permissions and the owner of the folder");
  std::ranges::sort(result.certificates, {}, [](const certificate& one) {
    return std::tuple(one.name, one.until, one.serial);
  });
  return result;
}

expected<certificate> issue(const fs::path& folder, const order& what, const fs::path& out) {
  const auto held = hold(folder);
  if (!held)
    return fail(held.error());
  if (auto ok = check_order(what, held->known); !ok)
    return fail(ok.error());
  for (const auto& one : held->known.certificates)
    if (one.name == what.name && !one.revoked && one.until > now_s())
      return fail(ec::conflict,
                  what.name + " has a certificate that holds until " + utc_text(one.until),
                  "Renew it, revoke it first, or take another name");
  return hand_out(folder, held->by, what, folder_draft::make(out));
}

expected<certificate> renew(const fs::path& folder, const std::string& name, seconds valid,
                            const fs::path& out) {
  const auto held = hold(folder);
  if (!held)
    return fail(held.error());
  const certificate* last = nullptr;
  for (const auto& one : held->known.certificates)
    if (one.name == name)
      last = &one;
  if (last == nullptr)
    return fail(ec::not_found, "there is no certificate of " + name,
                "\"tedit certs list\" says which there are, \"tedit certs issue\" makes one");
  if (last->revoked)
    return fail(ec::conflict, "the last certificate of " + name + " was revoked",
                "Whoever shall have one again gets it by \"tedit certs issue\"");
  const order what{last->what, name, last->hosts, valid};
  if (auto ok = check_order(what, held->known); !ok)
    return fail(ok.error());
  return hand_out(folder, held->by, what,
                  is_folder_of(out, name, *held->by.own.certificate)
                    ? folder_draft::make_exchange(out)
                    : folder_draft::make(out));
}

expected<std::vector<certificate>> revoke(const fs::path& folder, const revocation& whom) {
  const auto held = hold(folder);
  if (!held)
    return fail(held.error());
  std::vector<certificate> ended;
  std::set<std::string> serials;
  bool found = false;
  for (const auto& one : held->known.certificates) {
    const bool meant = whom.serial.empty() ? one.name == whom.name && one.until > now_s()
                                           : one.serial == whom.serial;
    found = found || meant;
    if (!meant || one.revoked)
      continue;
    serials.insert(one.serial);
    ended.push_back(one);
    ended.back().revoked = true;
  }
  const auto who = whom.serial.empty() ? "of " + whom.name : "with the serial " + whom.serial;
  if (!found)
    return fail(ec::not_found, "there is no certificate " + who + " that could be revoked",
                "\"tedit certs list\" says which there are");
  if (ended.empty())
    return fail(ec::conflict, "the certificate " + who + " was revoked before");
  const auto made = make_revoked(held->by.own, held->by.revoked.get(), serials);
  if (!made)
    return fail(made.error());
  if (auto done = replace_file(folder / revoked_file, to_pem(**made)); !done)
    return fail(done.error());
  return ended;
}

}  // namespace tedit::certs
