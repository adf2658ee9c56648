// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/toolbox.hpp"

#include "client-qt/tools/operations/context_panel.hpp"

namespace tedit::desktop {

toolbox::toolbox(window_context& in)
    : connection(in),
      recipes(in, *this),
      documents(in, connection, recipes),
      history(in),
      pictures(in, history),
      operations(in),
      results(in, operations.panel().preview()),
      viewing(in),
      section(in, results.panel()),
      selecting(in),
      loads(in, results.panel(), selecting),
      summary(in, results.panel(), selecting),
      receipt(in, selecting),
      compare(in, results.panel(), history),
      settings(in, results.panel()),
      certifying(in),
      probing(in, results.panel(), selecting),
      printing(in, selecting),
      jobs(in),
      help(in, operations.panel()),
      tour(in, documents, operations.panel()),
      recording(in, *this) {
  // nop
}

}  // namespace tedit::desktop
