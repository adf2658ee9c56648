// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>

#include <caf/stateful_actor.hpp>

#include "actors/errors.hpp"
#include "actors/pages/page_store.hpp"
#include "tests/simulation/server.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {

/// A solver's page store on another machine.
struct far_state {
  std::map<hash128, page_ptr> pages;
  std::size_t sent = 0;
  bool forgot = false;
  static inline const char* name = "far";
};

inline caf::behavior make_far(caf::stateful_actor<far_state>* self, int /*number*/) {
  return {[=](get_atom, const hash_list& ids, bool packed) -> caf::result<page_batch> {
            page_cache held(std::size_t{1} << 30);
            for (const auto& id : ids) {
              if (self->state.forgot || !self->state.pages.contains(id))
                return to_caf({ec::not_found, "a page is not here any more", {}, {}});
              held.put(self->state.pages.at(id));
            }
            self->state.sent += ids.size();
            return pack(held, ids, packed).value();
          },
          [](const doing& that) { that.what(); }};
}

}  // namespace tedit::actors
