// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/documents_tool.hpp"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QThreadPool>

#include <array>
#include <utility>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/model/format_words.hpp"
#include "client-qt/net/cad_import.hpp"
#include "client-qt/tools/connection/connection_tool.hpp"
#include "client-qt/tools/documents/document_keeping.hpp"
#include "client-qt/tools/documents/recent_documents.hpp"
#include "client-qt/tools/documents/remeshing.hpp"
#include "client-qt/tools/documents/server_library.hpp"
#include "client-qt/tools/documents/unit_question.hpp"
#include "client-qt/tools/documents/welcome_page.hpp"
#include "client-qt/tools/loads/loads_tool.hpp"
#include "client-qt/tools/pictures/kept_picture.hpp"
#include "client-qt/tools/probes/probes_tool.hpp"
#include "client-qt/tools/recipes/recipes_tool.hpp"
#include "client/recipe.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

static constexpr int most_recent = 12;

/// What is kept among the settings under a document's name.
static std::array<QString, 2> keys_of(const QString& document) {
  return {pins_key(document), drafts_key(document)};
}

documents_tool::documents_tool(window_context& in, connection_tool& connection,
                               recipes_tool& recipes)
    : in_(in),
      connection_(connection),
      recipes_(recipes),
      start_page_(new welcome_page),
      keeping_(nullptr) {
  in_.pages.addWidget(start_page_);
  in_.pages.setCurrentWidget(start_page_);
  connect(&in_.part, &document::opened, this, [this] {
    in_.pages.setCurrentWidget(&in_.view);
    remember(in_.part.name());
    if (connection_.is_local())
      in_.settings.setValue("unfinished", in_.part.name());
  });
  connect(&in_.part, &document::renamed, this, &documents_tool::follow_name);
  connect(&in_.part, &document::closed, this, [this] {
    in_.pages.setCurrentWidget(start_page_);
    forget_unfinished();
    show_recent();
  });
  wire_start_page();
  add_commands();
  auto* library = new server_library(in_, connection_);
  library->setParent(this);
  connect(library, &server_library::document_wanted, this, &documents_tool::open_document);
  connect(library, &server_library::gone, this, &documents_tool::forget);
  keeping_ = new document_keeping(in_, connection_);
  keeping_->setParent(this);
  (new remeshing(in_, connection_))->setParent(this);
  new unit_question(in_.part, in_.view);  // Of the view.
}

void documents_tool::wire_start_page() {
  connect(&in_.look, &appearance::changed, start_page_, &welcome_page::set_theme);
  connect(&in_.part.foreground(), &foreground_work::changed, start_page_,
          [this] { start_page_->show_activity(in_.part.foreground().current()); });
  connect(start_page_, &welcome_page::recent_changed, this,
          [this](const QStringList& names) { in_.settings.setValue("recent", names); });
  connect(start_page_, &welcome_page::cancel_wanted, &in_.part.foreground(),
          &foreground_work::cancel);
  connect(start_page_, &welcome_page::example_wanted, this,
          [this](const example& one) { open_file(one.mesh, one.load_cases); });
  connect(start_page_, &welcome_page::document_wanted, this, &documents_tool::open_document);
  connect(start_page_, &welcome_page::file_wanted, this, &documents_tool::ask_file);
  connect(start_page_, &welcome_page::tour_wanted, this,
          [this] { (void)in_.all_commands.trigger("help.tour"); });
  connect(start_page_, &welcome_page::server_wanted, &connection_, &connection_tool::ask);
}

void documents_tool::add_commands() {
  const QString file = command_groups::file();
  in_.all_commands.add(
    {"file.open",
     tr("Open"),
     file,
     "Ctrl+O",
     [this] { ask_file(); },
     {},
     tr("A mesh or a CAD file with its load cases, a document, or a recipe, which is run"),
     "file_open"});
  in_.all_commands.add(
    {"file.connect", tr("Connect to a server"), file, {}, [this] { connection_.ask(); }});
  in_.all_commands.add({"file.close", tr("Close the part"), file, "Ctrl+W",
                        [this] { in_.part.files().close(); }, in_.has_part()});
  in_.all_commands.add(
    {"file.export", tr("Export"), file, "Ctrl+E", [this] { ask_export(); }, in_.has_part(),
     tr("Writes the part as a file for other programs: the mesh, its boundary or its fields"),
     "export"});
}

bool documents_tool::shows_start_page() const {
  return in_.pages.currentWidget() == start_page_;
}

// -- opening -------------------------------------------------------------------------

/// Meshes are opened with the load cases that came beside them.
void documents_tool::open_files(const QStringList& files) {
  QString mesh;
  QString recipe;
  QStringList loads;
  for (const auto& file : files) {
    if (!file.endsWith(".json"))
      mesh = mesh.isEmpty() ? file : mesh;
    else if (client::is_recipe(file.toStdString()))
      recipe = file;
    else
      loads << file;
  }
  if (!recipe.isEmpty())
    recipes_.run(recipe);
  else if (is_cad_file(mesh) || is_surface_file(mesh))
    ask_size(mesh, loads);
  else if (!mesh.isEmpty())
    open_file(mesh, loads);
  else if (in_.part.head())
    set_loads(loads);
  else if (!loads.isEmpty())
    emit in_.part.failed(
      tr("Open %1").arg(loads.first()),
      {ec::bad_input,
       "this is no recipe: it has no \"steps\"",
       "Give a load case together with its mesh; docs/recipes.md says what a recipe is",
       {}});
}

/// Load cases without a mesh are meant for the part that is open.
void documents_tool::set_loads(const QStringList& files) {
  for (const auto& file : files) {
    const auto read = protocol::load_case_from_file(file.toStdString());
    if (read)
      in_.part.loads().set(*read);
    else
      emit in_.part.failed(tr("Open %1").arg(file), read.error());
  }
}

void documents_tool::open_file(const QString& mesh, const QStringList& load_cases) {
  in_.log.write(tr("opening %1").arg(mesh));
  if (mesh.endsWith(".tedit"))
    return open_document_file(mesh);
  if (mesh.endsWith(".json"))
    return recipes_.run(mesh);
  connection_.when_connected([=, this] {
    if (is_cad_file(mesh) || is_surface_file(mesh))
      in_.part.files().import_cad({mesh, load_cases, "mm", "medium", {}});
    else
      in_.part.files().import(mesh, load_cases);
  });
}

void documents_tool::open_document(const QString& name) {
  connection_.when_connected([=, this] { in_.part.files().open(name); });
}

void documents_tool::restore() {
  const QString name = in_.settings.value("unfinished").toString();
  if (name.isEmpty())
    return;
  in_.log.write(tr("the last session was not closed; opening %1 again").arg(name));
  open_document(name);
}

void documents_tool::forget_unfinished() {
  in_.settings.remove("unfinished");
}

/// A document is served from the local server's folder; another server gets it whole.
void documents_tool::open_document_file(const QString& path) {
  const QFileInfo file(path);
  const QDir documents(in_.server.folder() + "/documents");
  if (in_.link.current() == remote::state::connected && !connection_.is_local())
    in_.part.files().add(path);
  else if (file.absoluteDir() == documents)
    open_document(file.completeBaseName());
  else
    copy_here(path, documents.path());
}

/// One from elsewhere is copied, aside. What cannot be opened leaves no copy.
void documents_tool::copy_here(const QString& path, const QString& folder) {
  const QDir documents(folder);
  const QString stem = valid_name(QFileInfo(path).completeBaseName());
  QString name = stem;
  for (int i = 2; documents.exists(name + ".tedit"); ++i)
    name = stem + "-" + QString::number(i);
  const QString to = documents.absoluteFilePath(name + ".tedit");
  QThreadPool::globalInstance()->start([path, to, tool = QPointer(this)] {
    QDir().mkpath(QFileInfo(to).path());
    if (QFile::exists(path + "-wal"))  // Steps that are not in the main file yet.
      QFile::copy(path + "-wal", to + "-wal");
    const bool copied = QFile::copy(path, to);
    QMetaObject::invokeMethod(qApp, [=] {
      if (tool && copied)
        tool->open_copy(to, path);
      else if (tool)
        emit tool->in_.part.failed(
          tr("Open %1").arg(path),
          {ec::io_error, "cannot copy the document to " + to.toStdString(),
           "Check that it can be read and that there is room", path.toStdString()});
    });
  });
}

void documents_tool::open_copy(const QString& copy, const QString& of) {
  connection_.when_connected([=, this] { in_.part.files().open_copy(copy, of); });
}

// -- recent documents ----------------------------------------------------------------

void documents_tool::remember(const QString& document) {
  auto recent = in_.settings.value("recent").toStringList();
  recent.removeAll(document);
  recent.prepend(document);
  for (const auto& old : recent.mid(most_recent))
    drop_kept(old);
  recent = recent.mid(0, most_recent);
  QVariantMap used = in_.settings.value("recent_used").toMap();
  used[document] = QDateTime::currentDateTime();
  for (const auto& name : used.keys())
    if (!recent.contains(name))
      used.remove(name);
  in_.settings.setValue("recent", recent);
  in_.settings.setValue("recent_used", used);
}

/// What was kept to find a document as it was left.
void documents_tool::drop_kept(const QString& document) {
  remove_pictures(in_.server.folder(), document);
  for (const auto& key : keys_of(document))
    in_.settings.remove(key);
}

/// Of a document that is gone nothing stays: a later one of its name is another.
void documents_tool::forget(const QString& document) {
  drop_kept(document);
  auto recent = in_.settings.value("recent").toStringList();
  recent.removeAll(document);
  in_.settings.setValue("recent", recent);
  if (in_.settings.value("unfinished") == document)
    forget_unfinished();
  show_recent();
}

/// What is kept under a document's name goes with it, instead of what an earlier one of the new
/// name left. Of several windows that share the settings the first one does it: then the name
/// before is not listed any more.
void documents_tool::follow_name(const QString& before) {
  const QString now = in_.part.name();
  if (connection_.is_local() && in_.settings.value("unfinished") == before)
    in_.settings.setValue("unfinished", now);
  in_.settings.sync();
  auto recent = in_.settings.value("recent").toStringList();
  if (!recent.contains(before))
    return;
  recent.removeAll(now);
  recent[recent.indexOf(before)] = now;
  auto used = in_.settings.value("recent_used").toMap();
  used[now] = used.take(before);
  in_.settings.setValue("recent", recent);
  in_.settings.setValue("recent_used", used);
  for (std::size_t i = 0; i < keys_of(now).size(); ++i) {
    const auto kept = in_.settings.value(keys_of(before)[i]);
    in_.settings.remove(keys_of(before)[i]);
    if (kept.isValid())
      in_.settings.setValue(keys_of(now)[i], kept);
    else
      in_.settings.remove(keys_of(now)[i]);
  }
  move_pictures(in_.server.folder(), before, now);
}

void documents_tool::show_recent() {
  const auto used = in_.settings.value("recent_used").toMap();
  std::vector<recent_document> all;
  for (const auto& name : in_.settings.value("recent").toStringList())
    all.push_back({name, used[name].toDateTime(), QImage(picture_file(in_.server.folder(), name))});
  start_page_->set_recent(std::move(all));
}

// -- questions -----------------------------------------------------------------------

void documents_tool::ask_file() {
  auto* dialog = new QFileDialog(
    &in_.window,
    tr("Open a mesh, a CAD file or a surface and its load cases, a document or a recipe"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setNameFilters(
    {tr("Meshes, CAD files, surfaces, load cases, recipes, documents (%1)")
       .arg(patterns_to_read(in_.link.formats()) + " " + cad_patterns() + " *.json *.tedit"),
     tr("All files (*)")});
  connect(dialog, &QFileDialog::filesSelected, this, &documents_tool::open_files);
  dialog->open();
}

/// What the coordinates are in: most surface files do not say it.
static QComboBox* add_unit_choice(QMessageBox& question) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* choice = new QComboBox;
  choice->setObjectName("surface_unit");
  choice->addItem(documents_tool::tr("Millimetres"), "mm");
  choice->addItem(documents_tool::tr("Centimetres"), "cm");
  choice->addItem(documents_tool::tr("Metres"), "m");
  choice->addItem(documents_tool::tr("Inches"), "in");
  auto* label = new QLabel(documents_tool::tr("Its lengths are in, where it does not say it"));
  label->setBuddy(choice);
  layout->addWidget(label);
  layout->addWidget(choice);
  auto* grid = qobject_cast<QGridLayout*>(question.layout());
  auto* buttons = question.findChild<QDialogButtonBox*>();
  if (grid && buttons) {  // Between the text and the buttons.
    grid->removeWidget(buttons);
    grid->addWidget(row, grid->rowCount(), 0, 1, grid->columnCount());
    grid->addWidget(buttons, grid->rowCount(), 0, 1, grid->columnCount());
  }
  return choice;
}

void documents_tool::ask_size(const QString& cad_file, const QStringList& load_cases) {
  auto* question = new QMessageBox(&in_.window);
  question->setObjectName("cad_size");
  question->setAttribute(Qt::WA_DeleteOnClose);
  const bool surface = is_surface_file(cad_file);
  question->setWindowTitle(surface ? tr("Open a surface") : tr("Open a CAD file"));
  question->setText(tr("How fine shall the mesh of %1 be?").arg(QFileInfo(cad_file).fileName()));
  question->setInformativeText(
    tr("Coarse: one quadratic tet through a usual wall. Medium: two. Fine: three."));
  auto* unit = surface ? add_unit_choice(*question) : nullptr;
  const std::pair<QString, QString> sizes[] = {
    {"coarse", tr("Coarse")}, {"medium", tr("Medium")}, {"fine", tr("Fine")}};
  for (const auto& [size, words] : sizes) {
    auto* button = question->addButton(words, QMessageBox::AcceptRole);
    button->setObjectName(size);
    if (size == "medium")
      question->setDefaultButton(button);
    connect(button, &QPushButton::clicked, this, [=, this, size = size] {
      in_.log.write(tr("opening %1").arg(cad_file));
      connection_.when_connected(
        [=, this, in_unit = unit ? unit->currentData().toString() : QString("mm")] {
          in_.part.files().import_cad({cad_file, load_cases, in_unit, size, {}});
        });
    });
  }
  question->addButton(QMessageBox::Cancel);
  question->open();
}

void documents_tool::ask_export() {
  auto* dialog = new QFileDialog(&in_.window, tr("Export"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const auto suffix_in = [](const QString& filter) { return filter.section("*.", 1).chopped(1); };
  auto filters = filters_to_write(in_.link.formats());
  filters << tr("CAD model with all edits (*.step)");
  dialog->setNameFilters(filters);
  dialog->setDefaultSuffix(suffix_in(filters.value(0)));
  connect(dialog, &QFileDialog::filterSelected, dialog,
          [=](const QString& filter) { dialog->setDefaultSuffix(suffix_in(filter)); });
  connect(dialog, &QFileDialog::fileSelected, &in_.part.files(), &file_requests::export_to);
  dialog->open();
}

}  // namespace tedit::desktop
