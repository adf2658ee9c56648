// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/execution.hpp"
#include "client/comparison.hpp"
#include "client/preview.hpp"
#include "client/print_check.hpp"
#include "client/surface.hpp"
#include "client/types.hpp"
#include "fem/load_case.hpp"
#include "fem/receipt.hpp"
#include "mesh/features/select.hpp"
#include "ops/sdk/operation.hpp"
#include "protocol/operation_message.hpp"

namespace tedit::client {

/// A connection to a server, with one document open at a time. Blocking calls, one background I/O
/// thread; thread-safe, but no call may run when it is destroyed. Lengths are m, as everywhere.
///
/// Errors of every request: what the server says, `service_unavailable` at once when the connection
/// breaks (it does not come back: connect anew), `protocol_error` when the server breaks the
/// protocol, `timeout` when the time limit of `connect_options` passes (the request is cancelled
/// then). Requests about a document also: `invalid_argument` when none is open.
/// Changes of a document take `change_terms`: errors then also `conflict`, when the head is not the
/// expected version (the message says whose change it is) or the edit id was used for another
/// change. Requests with an `execution` end with `cancelled` once the server has confirmed it (30 s
/// at most), or with their result when that came first; progress is reported by the calling thread.
class client {
public:
  /// Connects and introduces itself. Errors: `invalid_argument` for the URL, `service_unavailable`
  /// when no server can be reached there, `untrusted_server` for its certificate (`server_trust`),
  /// `protocol_error` when it speaks another major version, what it says when it refuses the token.
  [[nodiscard]] static expected<std::unique_ptr<client>> connect(const connect_options& options,
                                                                 events handlers);

  ~client();  ///< Closes the connection; 2 s at most.
  client(const client&) = delete;
  client& operator=(const client&) = delete;

  [[nodiscard]] bool connected() const noexcept;

  /// Ends the connection at once; calls that run fail with `service_unavailable`. Thread-safe.
  void abort();

  /// The operations that the server offers, and the plugins that it does not use.
  [[nodiscard]] expected<operation_catalogue> operations();

  [[nodiscard]] expected<server_status> status();

  // -- the documents of the server ----------------------------------------------------------

  /// By name. Files are not looked into: that one is no document is said when it is opened.
  [[nodiscard]] expected<std::vector<document_info>> list_documents();

  /// Makes a document of the name `copy` with all versions of another one, which may be open, here
  /// or elsewhere, or not. The copy is not opened. Errors: `invalid_argument` for a name that no
  /// document can have, `conflict` for one that is taken and while the document is opened, closed
  /// or renamed, `not_found`, `storage_error` for a document that is damaged.
  [[nodiscard]] expected<void> copy_document(const std::string& document, const std::string& copy,
                                             const execution& run = {});

  /// Gives a document of the server another name, whether anybody has it open or not; all who have
  /// it open hear of it. Nothing when it has that name already. Errors: `invalid_argument` for a
  /// name that no document can have, `conflict` for one that is taken and while another program has
  /// the document, `not_found`, `storage_error` for a document that is damaged.
  [[nodiscard]] expected<void> rename_on_server(const std::string& document,
                                                const std::string& name);

  /// Takes a document from the server for good; no document is open then if it was the open one.
  /// Errors: `conflict` while another client has it open or something is done with it, `not_found`,
  /// `storage_error` for a file that is no document.
  [[nodiscard]] expected<void> delete_document(const std::string& document);

  // -- the document -----------------------------------------------------------------------

  /// Opens a document instead of the one before; it is made when it is not there. An empty name
  /// makes a new unnamed one. `watch_surface` and `watch_fields` say what is sent unasked. `held`,
  /// a surface of it from an earlier connection, is not sent again: the first surface to arrive is
  /// the difference to it, where the document has that version.
  [[nodiscard]] expected<document_state> open(const std::string& name, bool watch_surface,
                                              bool watch_fields, const surface_model& held = {});

  /// Closes the open document: nothing of it is sent any more, and others may delete it. Nothing
  /// when none is open.
  [[nodiscard]] expected<void> close_document();

  /// Uploads a mesh file in pieces of 256 KiB, of which 4 MiB at most wait in memory, and makes it
  /// the new head. `unit` is the file's length unit, "mm" when empty.
  /// Errors: also `io_error`, `bad_input` for an empty file.
  [[nodiscard]] expected<committed> import_file(const std::filesystem::path& path,
                                                const std::string& unit, const execution& run,
                                                const change_terms& terms = {});

  /// Uploads a document file (.tedit) and makes it a document of the server, which is not opened;
  /// returns its name: `name`, or with `or_next_free` the next one that is free (NAME-2, ...).
  /// Errors: also `conflict` for a name that is taken, `storage_error` for a file that is no
  /// document or damaged, `io_error`.
  [[nodiscard]] expected<std::string> add_document(const std::filesystem::path& path,
                                                   const std::string& name, bool or_next_free,
                                                   const execution& run);

  /// Uploads a CAD file (STEP, IGES, BREP) or a closed surface (STL, OBJ, PLY, 3MF), which the
  /// server meshes, and makes it a document of the server as `add_document` does; without a name it
  /// is a temporary one. Errors: also what is wrong with the file (`bad_input`,
  /// `unsupported_format`, `mesher_failed`, ...), `service_unavailable` where the server meshes
  /// none.
  [[nodiscard]] expected<added_part> import_part(const std::filesystem::path& path,
                                                 const std::string& name,
                                                 const part_options& options, const execution& run);

  /// Gives the open document another name, also one that the server made up; all who have it open
  /// hear of it. Nothing when it has that name already. `before`: refused (`conflict`) when its
  /// name is another by now; empty: any. Errors: also `invalid_argument` for a name that no
  /// document can have, `conflict` for one that is taken.
  [[nodiscard]] expected<void> rename_document(const std::string& name,
                                               const std::string& before = {});

  /// Replaces the load case of this name at the head, or adds it. A running solve of the old one
  /// ends with `superseded`; the new one is solved by itself then.
  [[nodiscard]] expected<void> set_load_case(const fem::load_case& loads,
                                             const change_terms& terms = {});

  /// Takes a load case from the head, the last one, too. Errors: also `not_found`.
  [[nodiscard]] expected<void> remove_load_case(const std::string& name,
                                                const change_terms& terms = {});

  /// Gives a version a name (one line, 80 characters) and a note (4000) instead of those it had.
  /// Errors: also `not_found`, `invalid_argument`.
  [[nodiscard]] expected<void> annotate(std::uint32_t number, const std::string& name,
                                        const std::string& note, const change_terms& terms = {});

  /// What every field event and section has from now on beside the usual; until the document is
  /// opened again. The fields of the head come again with it; when they cannot, the result says
  /// why, else it is empty. Fields that arrived before the call are forgotten. Nothing comes where
  /// the head's last solve is `held_solve`, of which the caller has all that. Errors:
  /// `invalid_argument` for a name that is none, naming those that there are.
  [[nodiscard]] expected<std::string> watch_fields(const watched_quantities& wanted,
                                                   std::uint64_t held_solve = 0);

  /// Applies an operation to the head and returns once the new version is durable. When
  /// `expected_version` is given and not the head, the edit is refused (`conflict`); with
  /// `carry_over` only where it would touch anything that was changed since. `loads` says what
  /// becomes of loads and supports whose surface goes.
  [[nodiscard]] expected<committed> edit(const std::string& operation,
                                         const std::vector<surface_id>& surfaces,
                                         const ops::parameters& values, const execution& run,
                                         const std::string& expected_version = {},
                                         const fem::carry_settings& loads = {},
                                         const std::string& edit_id = {}, bool carry_over = false);

  /// Asks what such an edit would make of the head; nothing is changed or kept. The arguments are
  /// those of `edit`, which takes the result over at once when it follows with the same. Applied
  /// to a copy of `surface()`, the answer's difference gives the surface to show. Errors: those of
  /// `edit`, and `superseded` when the document is changed or another preview is asked for
  /// meanwhile.
  [[nodiscard]] expected<edit_preview> preview_edit(
    const std::string& operation, const std::vector<surface_id>& surfaces,
    const ops::parameters& values, const execution& run, const std::string& expected_version = {},
    const fem::carry_settings& loads = {}, preview_kind kind = preview_kind::whole);

  /// The surface of any version, by its number; head and `surface()` stay as they are. Errors: also
  /// `not_found`.
  [[nodiscard]] expected<surface_model> surface_of(std::uint32_t number, const execution& run = {});

  [[nodiscard]] expected<committed> undo(const change_terms& terms = {});
  [[nodiscard]] expected<committed> redo(const change_terms& terms = {});

  /// Makes any version the head, by its number; undo and redo go along its branch from then on.
  /// Errors: also `not_found`.
  [[nodiscard]] expected<committed> go_to(std::uint32_t number, const change_terms& terms = {});

  /// Cuts the head with the plane through `at` (m) across `normal`, with the field of a load case;
  /// an empty name: the only one, or the envelope of several. Errors: also `superseded` when
  /// another section was asked for meanwhile.
  [[nodiscard]] expected<section> cut(const vec3& at, const vec3& normal,
                                      const std::string& load_case, const execution& run);

  /// What two versions differ in, by their numbers; with a `load_case` also the difference of its
  /// fields at the boundary of `after`. Fields are those that the server has at hand: of a version
  /// that was not solved since the document was opened there are none, and the result says so. The
  /// head stays where it is. Errors: also `not_found` for a version, or for a load case that
  /// neither has.
  [[nodiscard]] expected<comparison> compare(std::uint32_t before, std::uint32_t after,
                                             const std::string& load_case = {},
                                             const execution& run = {});

  /// What hinders printing a version in 3D, by its number; nothing: the head. Changes nothing.
  /// Errors: also `invalid_argument` for a number that is out of its range (`tedit.v1.CheckPrint`),
  /// `not_found`.
  [[nodiscard]] expected<print_check> check_print(const print_settings& settings,
                                                  std::optional<std::uint32_t> version = {},
                                                  const execution& run = {});

  /// Solves on the head, one load case or several together; from then on the server solves every
  /// new head with these settings. Fields that arrived before the call are forgotten.
  [[nodiscard]] expected<solve_outcome> solve_cases(const solve_settings& settings,
                                                    const execution& run);

  /// Ends the solve that runs, whoever asked for it, also one that followed a new head by itself;
  /// calls that wait for it fail with `cancelled`. Later heads are solved as before. Nothing when
  /// none runs.
  [[nodiscard]] expected<void> cancel_solve();

  /// The same, for the report of the first load case or the only one.
  [[nodiscard]] expected<solve_report> solve(const solve_settings& settings, const execution& run);

  /// Whom the token names and what it allows, as the server said when it was connected to.
  [[nodiscard]] own_access access() const;

  /// The formats of mesh files that the server reads and writes, as it said when it was connected
  /// to.
  [[nodiscard]] std::vector<offered_format> formats() const;

  /// The server's program and version, for people, as it said when it was connected to.
  [[nodiscard]] std::string server_program() const;

  /// A version as a file's bytes; `format` is the name of one that the server writes, `version_id`
  /// empty: the head; `unit` as for import. With `document_format` the whole document, both must be
  /// empty then. `load_case`: of `inp` and `bdf`, the deck of this load case of the version, ready
  /// for CalculiX or Nastran. Errors: also `invalid_argument` for the format, naming those that
  /// there are, `not_found` for the load case.
  [[nodiscard]] expected<std::vector<char>> export_file(const std::string& format,
                                                        const std::string& version_id,
                                                        const std::string& unit,
                                                        const execution& run,
                                                        const std::string& load_case = {});

  /// Surfaces of the head that belong together.
  [[nodiscard]] expected<std::vector<found_feature>> select(const selection_query& query,
                                                            const execution& run);

  /// All versions, with what their edits reported when `reports` is set.
  [[nodiscard]] expected<history> get_history(bool reports = false);

  // -- what is sent unasked -----------------------------------------------------------------

  /// Waits until the surface of this version has arrived completely; at once when it is the one
  /// that is held. When it has been replaced since, each arrival is handed out once.
  /// Errors: `timeout`, `service_unavailable`; `protocol_error` when an update did not fit to what
  /// was held (open the document again).
  [[nodiscard]] expected<surface_event> wait_surface(const std::string& version_id,
                                                     std::chrono::milliseconds patience);

  /// Waits until the fields of this version have arrived completely: that of the load case, or
  /// those of several in their order and then their envelope's. Of several solves the latest. The
  /// last four solves are kept, but none from before the version became the head. Errors:
  /// `timeout`, `service_unavailable`. Cost: a copy of the arrays.
  /// `solve`: of that solve (`solve_outcome::solve`); 0: of any.
  [[nodiscard]] expected<std::vector<field_event>> wait_fields(const std::string& version_id,
                                                               std::chrono::milliseconds patience,
                                                               std::uint64_t solve = 0);

  /// The same, for the last of them: the load case's, or the envelope's of several.
  [[nodiscard]] expected<field_event> wait_field(const std::string& version_id,
                                                 std::chrono::milliseconds patience);

  /// The surface that is held now. Cheap: the copy shares the values.
  [[nodiscard]] surface_model surface() const;

private:
  struct impl;
  explicit client(std::unique_ptr<impl> made);

  std::unique_ptr<impl> impl_;
};

}  // namespace tedit::client
