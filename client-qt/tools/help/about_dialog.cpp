// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/help/about_dialog.hpp"

#include <QApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <vtkVersion.h>

#include "client-qt/widgets/theme.hpp"

namespace tedit::desktop {

namespace {

struct about_dialog_phrases {
  Q_DECLARE_TR_FUNCTIONS(about)
};

}  // namespace

std::vector<used_library> used_libraries() {
  return {
    {"Qt", qVersion(), "LGPL-3.0", about_dialog_phrases::tr("this window")},
    {"VTK", vtkVersion::GetVTKVersion(), "BSD-3-Clause",
     about_dialog_phrases::tr("the picture of the part")},
    {"Protocol Buffers", "3.21", "BSD-3-Clause",
     about_dialog_phrases::tr("messages between window and server")},
    {"Boost", "1.74", "BSL-1.0", about_dialog_phrases::tr("the connection")},
    {"C++ Actor Framework", "0.17", "BSD-3-Clause or BSL-1.0",
     about_dialog_phrases::tr("the server's processes")},
    {"CGAL", "5.5", "GPL-3.0-or-later, LGPL-3.0-or-later",
     about_dialog_phrases::tr("exact geometry")},
    {"TetGen", "1.5", "AGPL-3.0-or-later",
     about_dialog_phrases::tr("filling with tets, a program of its own")},
    {"Eigen", "3.4", "MPL-2.0", about_dialog_phrases::tr("linear algebra")},
    {"SQLite",
     {},
     about_dialog_phrases::tr("public domain"),
     about_dialog_phrases::tr("documents")},
    {"Zstandard", {}, "BSD-3-Clause", about_dialog_phrases::tr("documents")},
    {"xxHash", {}, "BSD-2-Clause", about_dialog_phrases::tr("ids of versions")},
    {"OpenSSL", {}, "Apache-2.0", about_dialog_phrases::tr("checksums of files and tokens")},
    {"Vulkan headers, volk", {}, "Apache-2.0, MIT", about_dialog_phrases::tr("the solver on GPUs")},
    {"spdlog, fmt", {}, "MIT", about_dialog_phrases::tr("the server's log")},
    {"CLI11", {}, "BSD-3-Clause", about_dialog_phrases::tr("the command line")},
    {"toml++", {}, "MIT", about_dialog_phrases::tr("configuration")},
    {"nlohmann-json", {}, "MIT", about_dialog_phrases::tr("JSON")},
    {"tl::expected", {}, "CC0-1.0", about_dialog_phrases::tr("errors")}};
}

about_dialog::about_dialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("About TEdit"));
  resize(740, 560);
  auto* column = new QVBoxLayout(this);
  auto* mark = new QLabel;
  mark->setPixmap(window_icon().pixmap(64, 64));
  column->addWidget(mark);
  auto* name = new QLabel("TEdit " + QApplication::applicationVersion());
  name->setObjectName("version");
  name->setProperty("role", "title");
  name->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(name);
  auto* licence = new QLabel(tr(
    "Edits tetrahedral meshes of parts and shows the new stress at once.\n\n"
    "TEdit is free software under the GNU Affero General Public License, version 3 or (at your "
    "option) any later version. It comes without any warranty. Whoever lets others use a changed "
    "TEdit over a network must offer them its source."));
  licence->setWordWrap(true);
  column->addWidget(licence);
  auto* title = new QLabel(tr("Built with"));
  title->setProperty("role", "section");
  column->addWidget(title);
  auto* list = new QTreeWidget;
  list->setObjectName("libraries");
  list->setAccessibleName(tr("Built with"));
  list->setRootIsDecorated(false);
  list->setSelectionMode(QAbstractItemView::NoSelection);
  list->setHeaderLabels({tr("Library"), tr("Version"), tr("Licence"), tr("For")});
  for (const auto& one : used_libraries())
    new QTreeWidgetItem(list, {one.name, one.version, one.licence, one.purpose});
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  column->addWidget(list, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  column->addWidget(buttons);
}

}  // namespace tedit::desktop
