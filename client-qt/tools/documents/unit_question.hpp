// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

#include <optional>

#include "client-qt/model/file_requests.hpp"
#include "client-qt/model/part_size.hpp"

class QLabel;

namespace tedit::desktop {

class viewport;

/// Where an imported part is of an odd size, asks over the view which unit its file was written in:
/// the part can be read anew in another one, or kept. Blocks nothing; goes with the part.
class unit_question : public QFrame {
  Q_OBJECT

public:
  unit_question(document& part, viewport& view);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void look();
  void ask(const part_size& size);
  void place();

  document& part_;
  viewport& view_;
  QLabel* words_;
  std::optional<imported_file> from_;
  bool looked_ = true;
};

}  // namespace tedit::desktop
