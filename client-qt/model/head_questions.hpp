// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <functional>
#include <memory>
#include <vector>

#include "client-qt/model/version_store.hpp"
#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;

/// What an edit would make; its version is nowhere but here.
struct shown_preview {
  client::edit_preview made;  ///< Its `surface` is moved on to below.
  shared_surface before;      ///< The head's.
  shared_surface surface;
};
using shared_preview = std::shared_ptr<const shown_preview>;

/// An edit that may be made of the head.
struct edit_wish {
  QString operation;
  std::vector<surface_id> surfaces;
  ops::parameters values;
  fem::carry_settings loads = {};  ///< What becomes of loads whose surface goes.

  friend bool operator==(const edit_wish&, const edit_wish&) = default;
};

/// Questions about the head and other versions, which change nothing. Each is answered once, also
/// by an error: that is no failure to be told.
class head_questions {
  Q_DECLARE_TR_FUNCTIONS(head_questions)

public:
  head_questions(document& part, remote& link) : part_(part), link_(link) {}

  /// What an edit would make of the head. A newer question makes an older one `superseded`.
  ticket preview(const edit_wish& wish, client::preview_kind kind,
                 remote::reply<shared_preview> done, const remote::progress& advanced = {});
  /// Which surfaces belong together, or why none do.
  void select(const selection_query& query, remote::reply<std::vector<found_feature>> done);
  /// The surface of any version.
  void surface_of(std::uint32_t number, remote::reply<shared_surface> done);
  /// What two versions differ in, with the difference of a load case's fields that the server has.
  void compare(std::uint32_t before, std::uint32_t after, const std::string& load_case,
               remote::reply<shared_comparison> done);
  /// A plane through the head, with the field of a load case as `client::cut` says. A newer
  /// question makes an older one `superseded`; one that is cancelled among what runs is `cancelled`
  /// at once.
  void cut(const vec3& at, const vec3& normal, const std::string& load_case,
           remote::reply<client::section> done);
  /// What hinders printing a version, with its progress among what runs. What is returned cancels
  /// it: it is `cancelled` at once, as when that is done there. Nothing once it is answered.
  std::function<void()> check_print(const print_settings& settings, std::uint32_t number,
                                    remote::reply<shared_print_check> done);

private:
  /// Lists it among what runs. The server may notice a cancel late: it is `cancelled` here at once,
  /// and an answer that comes after that is dropped.
  template <class T>
  std::function<void()> ask_listed(const QString& title, remote::work<T> call,
                                   remote::reply<T> done);

  document& part_;
  remote& link_;
};

}  // namespace tedit::desktop
