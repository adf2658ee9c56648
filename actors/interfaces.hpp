// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <caf/atom.hpp>
#include <caf/replies_to.hpp>
#include <caf/typed_actor.hpp>

#include "actors/comparison_messages.hpp"
#include "actors/local_messages.hpp"
#include "actors/messages.hpp"
#include "actors/print_messages.hpp"
#include "actors/worker_roles.hpp"

/// Every actor of the system by what it answers. Read this file first; docs/actors.md draws it.
namespace tedit::actors {

using cancel_atom = caf::atom_constant<caf::atom("cancel")>;
using catalog_atom = caf::atom_constant<caf::atom("catalogue")>;
using close_atom = caf::atom_constant<caf::atom("close")>;
using copy_atom = caf::atom_constant<caf::atom("copy")>;
using delete_atom = caf::atom_constant<caf::atom("delete")>;
using detach_atom = caf::atom_constant<caf::atom("detach")>;
using fetch_atom = caf::atom_constant<caf::atom("fetch")>;
using get_atom = caf::atom_constant<caf::atom("get")>;
using existing_atom = caf::atom_constant<caf::atom("existing")>;
using end_atom = caf::atom_constant<caf::atom("end")>;
using end_solve_atom = caf::atom_constant<caf::atom("endsolve")>;
using lies_at_atom = caf::atom_constant<caf::atom("liesat")>;
using list_atom = caf::atom_constant<caf::atom("list")>;
using load_atom = caf::atom_constant<caf::atom("load")>;
using rate_atom = caf::atom_constant<caf::atom("rate")>;
using rename_atom = caf::atom_constant<caf::atom("rename")>;
using rest_atom = caf::atom_constant<caf::atom("rest")>;
using status_atom = caf::atom_constant<caf::atom("status")>;
using wake_atom = caf::atom_constant<caf::atom("wake")>;
using tick_atom = caf::atom_constant<caf::atom("tick")>;

// -- on every node -----------------------------------------------------------------------

/// Holds and moves pages; one on every node.
using page_store_actor = caf::typed_actor<
  // The pages with these identities, at most 256 KiB, packed if that is wanted; `not_found` names a
  // missing one.
  caf::replies_to<get_atom, hash_list, bool>::with<page_batch>,
  // Pulls what this node lacks from another store, under a credit, and holds all that was named.
  caf::replies_to<fetch_atom, caf::actor, hash_list>::with<page_set>,
  // Bytes a second that came from another store; 0: not known. Of itself: of the slowest of those
  // where pages of its own results lie.
  caf::replies_to<rate_atom, caf::actor>::with<double>,
  // Where pages lie that a result of this process names as its own: who pulls them from here gets
  // them from there.
  caf::reacts_to<lies_at_atom, caf::actor, hash_list>>;

// -- workers: each may die at any time; its pool does the work again ----------------------

/// Reads and writes files and runs the plugins of operations.
using modeling_actor = caf::typed_actor<
  // Reads a mesh file.
  caf::replies_to<job_id, import_order>::with<import_result>,
  // Runs an operation; what it yields is checked elsewhere.
  caf::replies_to<job_id, edit_order>::with<operation_result>,
  // Writes a file.
  caf::replies_to<job_id, export_order>::with<export_result>,
  // Finds surfaces that belong together.
  caf::replies_to<job_id, select_order>::with<select_result>,
  // The operations there are.
  caf::replies_to<catalog_atom>::with<shared_catalogue>,
  // Ends a job early; it is then answered with `cancelled`.
  caf::reacts_to<cancel_atom, job_id>,
  // How it is.
  caf::replies_to<status_atom>::with<worker_status>>;

/// Improves the region of an edit and checks the postconditions; runs no plugin.
using optimizer_actor = caf::typed_actor<
  // Improves and checks a candidate; carries the load cases over.
  caf::replies_to<job_id, check_order>::with<check_result>,
  // Ends a job early.
  caf::reacts_to<cancel_atom, job_id>,
  // How it is.
  caf::replies_to<status_atom>::with<worker_status>>;

/// Solves load cases on one device.
using solver_actor = caf::typed_actor<
  // Solves; sends a frame to the order's listener after every outer round.
  caf::replies_to<job_id, solve_order>::with<solve_result>,
  // Ends a job early.
  caf::reacts_to<cancel_atom, job_id>,
  // How it is.
  caf::replies_to<status_atom>::with<worker_status>>;

/// The workers of all roles, or the pools that stand for them.
struct worker_set {
  modeling_actor modeling;
  optimizer_actor optimizer;
  solver_actor solver;

  /// Calls `f(role, actor)` for each.
  template <class F>
  void for_each(F&& f) const {
    f(worker_role::modeling, modeling);
    f(worker_role::optimizer, optimizer);
    f(worker_role::solver, solver);
  }
};

// -- in the server's process ---------------------------------------------------------------

/// Makes edits on the CAD models of parts, a process each, as many at once as the server allows, in
/// the order of arrival; one in each server.
using cad_editor_actor = caf::typed_actor<
  // Makes one. An edit that cannot be made on the model is an answer; errors are those of the
  // system.
  caf::replies_to<job_id, cad_order>::with<cad_outcome>,
  // Ends it early; it is then answered with `cancelled`.
  caf::reacts_to<cancel_atom, job_id>>;

/// Meshes CAD files and surfaces that clients sent, with programs that may die, as many at once as
/// the server allows, in the order of arrival; one in each server.
using part_importer_actor = caf::typed_actor<
  // Makes a document of one; it is told how far it is, and ended early by the order's own token.
  caf::replies_to<part_order>::with<part_document>,
  // From itself: whether those that wait are still wanted.
  caf::reacts_to<rest_atom>>;

/// Waits for the disk on behalf of all stores; a few in each server, each with a thread.
using disk_actor = caf::typed_actor<
  // Opens the document and reads all of it.
  caf::replies_to<load_atom, shared_file>::with<stored_document>,
  // Reads one version of an open document.
  caf::replies_to<load_atom, shared_file, version_query>::with<stored_version>,
  // Reads the CAD model of one of its versions.
  caf::replies_to<load_atom, shared_file, cad_query>::with<stored_cad>,
  // Writes one transaction; the answer means that it is durable.
  caf::replies_to<shared_file, stored_change>::with<acknowledged>,
  // The whole document as one file.
  caf::replies_to<copy_atom, shared_file>::with<exported>,
  // Checks a document that came from elsewhere and puts it into the folder.
  caf::replies_to<adoption>::with<acknowledged>,
  // Gives the document another name in its folder.
  caf::replies_to<rename_atom, shared_file, std::string>::with<acknowledged>,
  // Writes the document to another one of its folder, as it is after the commits before this.
  caf::replies_to<copy_atom, shared_file, copy_order>::with<acknowledged>,
  // The same for one that nobody has open, once all of it was read and found sound.
  caf::replies_to<file_copy>::with<acknowledged>,
  // Deletes the document and closes it.
  caf::replies_to<delete_atom, shared_file>::with<acknowledged>,
  // Deletes a document that nobody has open.
  caf::replies_to<deletion>::with<acknowledged>,
  // The documents that have a file in a folder.
  caf::replies_to<folder_query>::with<document_list>,
  // Closes the document for good: its lock is free.
  caf::replies_to<close_atom, shared_file>::with<acknowledged>,
  // Opens the file's descriptors ahead of a commit.
  caf::reacts_to<wake_atom, shared_file>,
  // Closes them until they are needed again.
  caf::reacts_to<rest_atom, shared_file>>;

/// The only writer of one document's file. Has the disks do the work, and the file's descriptors
/// closed when nothing came for a while.
using store_actor = caf::typed_actor<
  // Reads the whole document, pages included; asked once, when it is opened.
  caf::replies_to<load_atom>::with<stored_document>,
  // The mesh of one version, after that.
  caf::replies_to<load_atom, version_query>::with<stored_version>,
  // The CAD model of one version, after that.
  caf::replies_to<load_atom, cad_query>::with<stored_cad>,
  // Writes one transaction; the answer means that it is durable.
  caf::replies_to<stored_change>::with<acknowledged>,
  // The whole document as one file, as it is after the commits before this.
  caf::replies_to<copy_atom>::with<exported>,
  // Gives the document another name; the answer means that it is durable.
  caf::replies_to<rename_atom, std::string>::with<acknowledged>,
  // Writes the document to another one, as it is after the commits before this.
  caf::replies_to<copy_atom, copy_order>::with<acknowledged>,
  // Deletes the document; only its closing may follow.
  caf::replies_to<delete_atom>::with<acknowledged>,
  // Closes the document for good, after the commits before this.
  caf::replies_to<close_atom>::with<acknowledged>,
  // A commit is on its way.
  caf::reacts_to<wake_atom>,
  // From itself: nothing came since it was used so many times.
  caf::reacts_to<rest_atom, std::uint64_t>>;

/// One open document: the order of its edits, its version graph, its subscribers.
using session_actor = caf::typed_actor<
  // Hears the document's events from now on; the answer is its present state.
  caf::replies_to<attach_request>::with<session_snapshot>,
  // Hears no more.
  caf::reacts_to<detach_atom, caf::actor>,
  // Reads a mesh and makes it the head.
  caf::replies_to<import_request>::with<head_moved>,
  // Applies an operation to the head.
  caf::replies_to<apply_request>::with<head_moved>,
  // Shows what an operation would make of the head; superseded by whatever changes the document.
  caf::replies_to<preview_request>::with<previewed>,
  // Undo and redo.
  caf::replies_to<move_request>::with<head_moved>,
  // What makes no new version: load cases of the head, names of versions.
  caf::replies_to<note_request>::with<acknowledged>,
  // Gives the document another name, which its hub has found free; all subscribers hear of it.
  caf::replies_to<rename_atom, std::string>::with<document_renamed>,
  // Copies the document to another one, whose name its hub has found free.
  caf::replies_to<copy_atom, copy_order>::with<acknowledged>,
  // Deletes the document and ends, unless another than who asks has it open, or something is done
  // with it (`conflict`).
  caf::replies_to<delete_atom, caf::actor>::with<acknowledged>,
  // Who has the document open, and what it holds.
  caf::replies_to<status_atom>::with<session_status>,
  // Notes what somebody watches; answered by the result of the head with that, if it is at hand.
  caf::replies_to<watch_request>::with<held_result>,
  // Solves the head, and from then on every new head.
  caf::replies_to<solve_request>::with<solved>,
  // Ends the solve that runs, whoever asked for it; later heads are solved as before.
  caf::replies_to<end_solve_atom>::with<acknowledged>,
  // Writes a version as a file.
  caf::replies_to<export_request>::with<exported>,
  // Finds surfaces of the head that belong together.
  caf::replies_to<select_request>::with<selected>,
  // All versions.
  caf::replies_to<history_request>::with<session_history>,
  // One of them.
  caf::replies_to<version_request>::with<session_version>,
  // What two versions differ in, and their fields as far as these are at hand.
  caf::replies_to<comparison_request>::with<compared>,
  // What hinders printing a version.
  caf::replies_to<print_request>::with<print_checked>,
  // Ends a request early; it is then answered with `cancelled`.
  caf::reacts_to<cancel_atom, std::uint64_t>,
  // Closes the document and ends, unless somebody wants something of it (`conflict`). The answer is
  // what only it has.
  caf::replies_to<end_atom>::with<shared_remains>,
  // From itself: nobody has had it open for a while, unless that was called off since.
  caf::reacts_to<rest_atom, std::uint64_t>>;

/// Opens documents and finds those that are open.
using hub_actor = caf::typed_actor<
  // The session of a document; it is made when it is not there.
  caf::replies_to<std::string>::with<opened_document>,
  // The same of a document that there is, for those who may begin none.
  caf::replies_to<existing_atom, std::string>::with<opened_document>,
  // Makes a file that was sent a document.
  caf::replies_to<add_request>::with<added_document>,
  // Meshes a CAD file or a surface that was sent, and makes it a document.
  caf::replies_to<part_request>::with<added_document>,
  // Gives an open document another name; who asks for the one before still finds it.
  caf::replies_to<rename_request>::with<acknowledged>,
  // Copies a document, open or not, to a new one.
  caf::replies_to<copy_request>::with<added_document>,
  // Deletes a document that no other client has open.
  caf::replies_to<delete_request>::with<deleted_document>,
  // All documents, open or not.
  caf::replies_to<list_atom>::with<document_list>,
  // A session of which nobody wants anything: it is ended.
  caf::reacts_to<end_atom, session_actor>,
  // From itself: a document without a name of its own goes, if nobody came back to it.
  caf::reacts_to<rest_atom, std::string, std::uint64_t>,
  // How the workers are, and how many documents are open.
  caf::replies_to<status_atom>::with<server_status>,
  // The operations there are.
  caf::replies_to<catalog_atom>::with<shared_catalogue>>;

}  // namespace tedit::actors
