// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/remeshing.hpp"

#include <QMainWindow>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/connection/connection_tool.hpp"
#include "client-qt/tools/documents/remesh_form.hpp"

namespace tedit::desktop {

remeshing::remeshing(window_context& in, connection_tool& connection)
    : in_(in), connection_(connection) {
  in_.all_commands.add(
    {"file.mesh_anew",
     tr("Mesh anew with another size"),
     command_groups::file(),
     {},
     [this] { ask(); },
     [this] { return in_.part.head() && in_.part.files().cad_source(); },
     tr(
       "Reads the part's CAD file once more: finer or coarser, with shorter edges on picked walls"),
     {},
     tr("The part was not meshed from a CAD file since the window was opened: open its STEP, IGES "
        "or BREP file")});
}

/// Numbers of surfaces are those of the file as it was read.
void remeshing::ask() {
  const auto& source = *in_.part.files().cad_source();
  if (source.is_changed())
    return emit in_.part.failed(
      tr("Mesh anew with another size"),
      {ec::conflict, "the CAD file was changed or is gone since it was read",
       "Open it anew, then pick the walls", source.file.mesh.toStdString()});
  std::map<std::string, QString> names;
  for (const auto id : in_.picked.surfaces()) {  // Several may have one name.
    const QString number = QString::number(id);
    const QString name = in_.part.surface_name(id);
    names.emplace(number.toStdString(),
                  name.contains(number) ? name : QString("%1 (%2)").arg(number, name));
  }
  auto* form = new remesh_form(source.file, std::move(names), &in_.window);
  form->setAttribute(Qt::WA_DeleteOnClose);
  connect(form, &QDialog::accepted, this, [this, form] { mesh(form->wanted()); });
  form->open();
}

void remeshing::mesh(const imported_file& file) {
  in_.log.write(tr("meshing %1 anew").arg(file.mesh));
  connection_.when_connected([this, file] { in_.part.files().import_cad(file); });
}

}  // namespace tedit::desktop
