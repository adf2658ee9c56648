// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <string>
#include <vector>

class QLineEdit;

namespace tedit::desktop {

/// A path with a button that asks for one. Its value is the file's content, read when it is asked
/// for, so that what is sent is what the file holds then. What cannot be read goes on as the path:
/// the host says that it is no file.
class file_field : public QWidget {
  Q_OBJECT

public:
  /// `endings`: of the files that the dialog shows first, "svg"; of all where there are none.
  explicit file_field(const std::vector<std::string>& endings = {}, QWidget* parent = nullptr);

  /// The content as `base/attachment.hpp` writes it; empty where no path is given.
  [[nodiscard]] std::string content() const;
  /// What came from elsewhere (a recipe, the last edit) is shown by its name.
  void set_content(const std::string& text);

signals:
  void changed();

private:
  void ask();

  QLineEdit* path_;
  QStringList filters_;
  std::string given_;  ///< By `set_content`; until another path is typed.
};

}  // namespace tedit::desktop
