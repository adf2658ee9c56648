// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit {

struct server_options {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;                    ///< 0: any free one.
  std::vector<std::string> allowed_origins;  ///< Web pages that may connect.
  /// Names under which clients reach it, beside its address and those of its certificate.
  std::vector<std::string> allowed_hosts;
  /// A folder with the certificate that clients are shown (tls/server_identity.hpp). Empty: without
  /// TLS, which only an address of this machine alone may be.
  std::filesystem::path certificates;
  /// The same for any address: what lies between it and the clients is somebody else's business.
  bool unencrypted_behind_proxy = false;
  std::filesystem::path documents;  ///< The folder of the document files; made 0700.
  std::string token;                ///< Who knows it may do everything; not empty.
  /// Others and their tokens (actors/gateway/users.hpp), in a file that may come later. Empty:
  /// none.
  std::filesystem::path users;
  /// So often it is looked whether the token of each who is connected still holds.
  std::chrono::milliseconds access_every{30'000};
  std::string device = "auto";  ///< For solves that name none.

  /// Workers in processes of their own, which may die; else on threads of this process.
  bool worker_processes = true;
  std::filesystem::path program;  ///< The tedit program; empty: beside this executable.
  bool safe_mode = false;         ///< Only the plugins that came with the program.
  /// Workers that run plugins and read files are confined (sandbox/sandbox.hpp).
  bool sandbox = true;
  unsigned modeling_memory_mb = 0;  ///< Of one modeling worker; 0: three quarters of the machine's.
  /// An operation that failed so many edits of a document by ending its process is switched off
  /// there, and after so many documents everywhere; 0: never.
  unsigned quarantine_after = 3;
  unsigned modeling_workers = 1;
  unsigned optimizer_workers = 1;
  unsigned solver_workers = 1;
  /// Edits that are made on CAD models at once, behind all other work; 0: none, they are made when
  /// a model is exported.
  unsigned cad_jobs = 1;
  unsigned import_jobs = 1;  ///< CAD files and surfaces that are meshed at once; 0: none is taken.
  std::chrono::milliseconds import_limit{10 * 60 * 1000};  ///< Also for exports.
  std::chrono::milliseconds edit_limit{2 * 60 * 1000};
  std::chrono::milliseconds solve_limit{2 * 60 * 60 * 1000};
  /// A document that no client has open for so long is closed, and its memory is free.
  std::chrono::milliseconds unused_limit{120 * 1000};
  /// So long a worker that gets no more work stays for others to fetch its last result.
  std::chrono::milliseconds retired_stay{30 * 1000};
  /// So long after that goes a document to which nobody gave a name.
  std::chrono::milliseconds temporary_limit{3600 * 1000};
  /// A folder with the certificate of a server ("tedit certs"): workers of other machines may
  /// join at `node_port`. Empty: none can.
  std::filesystem::path node_certificates;
  std::string node_address = "127.0.0.1";
  std::uint16_t node_port = 0;  ///< 0: any that is free.
  /// Bytes of uploads that wait for their import, of one connection and of all together.
  std::uint64_t upload_bytes = std::uint64_t{2} << 30;
  std::uint64_t all_upload_bytes = std::uint64_t{4} << 30;
  /// Bytes of the fields of results that are kept for undo and for documents that are opened again.
  std::uint64_t result_bytes = std::uint64_t{512} << 20;
  /// Bytes of versions other than the heads of open documents that are kept for undo.
  std::uint64_t version_bytes = std::uint64_t{512} << 20;
  std::filesystem::path traces;  ///< Where the spans of requests go; empty: nowhere.
};

/// The whole server: gateway, hub, sessions, page store, workers or their pools. It runs on threads
/// of its own until `stop`.
class server {
public:
  /// Errors: `invalid_argument`, also for an address of other machines without TLS; `io_error` for
  /// a folder; `bad_input` for a certificate; `service_unavailable` for the port, or when this
  /// machine cannot confine workers.
  [[nodiscard]] static expected<std::unique_ptr<server>> start(const server_options& options);

  ~server();  ///< Stops.
  server(const server&) = delete;
  server& operator=(const server&) = delete;

  [[nodiscard]] std::uint16_t port() const;

  /// "ws://ADDRESS:PORT/v1", or "wss://..." with TLS.
  [[nodiscard]] std::string url() const;

  /// SHA-256 of the certificate that clients are shown, as they know a server by it; empty without
  /// TLS.
  [[nodiscard]] std::string fingerprint() const;

  /// Where workers of other machines join; nothing when none can.
  [[nodiscard]] std::optional<std::uint16_t> node_port() const;

  /// Says goodbye to all clients and ends all workers. What was acknowledged is in the documents.
  void stop();

private:
  struct impl;
  explicit server(std::unique_ptr<impl> made);

  std::unique_ptr<impl> impl_;
};

}  // namespace tedit
