// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

/// Shows a server's certificate that nobody vouches for, and asks once whether it is the right one.
/// `accepted` when a person says so. Where another one was known before, it says that first.
class trust_dialog : public QDialog {
  Q_OBJECT

public:
  explicit trust_dialog(const untrusted_server& what, QWidget* parent = nullptr);
};

}  // namespace tedit::desktop
