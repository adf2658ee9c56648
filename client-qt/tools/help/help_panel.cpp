// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/help/help_panel.hpp"

#include <QAbstractTextDocumentLayout>
#include <QComboBox>
#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>
#include <QVBoxLayout>

#include <utility>

#include "client-qt/model/language.hpp"

namespace tedit::desktop {

/// A picture wider than the panel would be cut off: it is left out.
class manual_page : public QTextBrowser {
public:
  manual_page() {
    connect(verticalScrollBar(), &QScrollBar::actionTriggered, this, &manual_page::let_go);
  }

  /// Brings a place to the top and keeps it there while the panel gets its width, until somebody
  /// scrolls.
  void hold(const QTextCursor& place) {
    held_ = place;
    bring_up();
  }
  void let_go() { held_ = {}; }

protected:
  void resizeEvent(QResizeEvent* event) override {
    QTextBrowser::resizeEvent(event);
    bring_up();
  }

  QVariant loadResource(int type, const QUrl& name) override {
    if (type == QTextDocument::ImageResource)
      return QImage(1, 1, QImage::Format_ARGB32);
    return QTextBrowser::loadResource(type, name);
  }

private:
  void bring_up() {
    if (held_.isNull())
      return;
    const auto* lines = document()->documentLayout();
    (void)lines->documentSize();  // So that all of it is laid out, and the bar knows its end.
    verticalScrollBar()->setValue(qRound(lines->blockBoundingRect(held_.block()).top()));
  }

  QTextCursor held_;
};

namespace {

constexpr double list_indent = 18;

QString text_of(const QString& name) {
  QFile file(":/help/" + name + ".md");
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

help_panel::help_panel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 0);
  auto* top = new QHBoxLayout;
  pages_ = new QComboBox;
  pages_->setObjectName("help_pages");
  pages_->setAccessibleName(tr("Page of the manual"));
  pages_->addItem(tr("This window"), "desktop");
  pages_->addItem(tr("Operations"), "operations");
  pages_->addItem(tr("Results"), "results");
  pages_->addItem(tr("Improving a mesh"), "improve");
  pages_->addItem(tr("Recipes"), "recipes");
  browser_ = new QPushButton(tr("In the browser"));
  browser_->setObjectName("help_browser");
  browser_->setToolTip(tr("The same page, with its pictures"));
  top->addWidget(pages_, 1);
  top->addWidget(browser_);
  column->addLayout(top);
  auto* row = new QHBoxLayout;
  letters_ = new QLineEdit;
  letters_->setObjectName("help_letters");
  letters_->setProperty("role", "search");  // As high as the button beside it.
  letters_->setPlaceholderText(tr("Search the help"));
  letters_->setAccessibleName(tr("Search the help"));
  letters_->setClearButtonEnabled(true);
  count_ = new QLabel;
  count_->setProperty("role", "faint");
  auto* next = new QPushButton(tr("Next"));
  row->addWidget(letters_, 1);
  row->addWidget(count_);
  row->addWidget(next);
  column->addLayout(row);
  page_ = new manual_page;
  page_->setObjectName("help_page");
  page_->setOpenExternalLinks(false);
  page_->setOpenLinks(false);
  page_->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  page_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  page_->setAccessibleName(tr("Help"));
  column->addWidget(page_, 1);
  connect(letters_, &QLineEdit::textChanged, this, &help_panel::search);
  connect(letters_, &QLineEdit::returnPressed, this, [this] { step(false); });
  connect(next, &QPushButton::clicked, this, [this] { step(false); });
  connect(pages_, &QComboBox::currentIndexChanged, this, [this] { lay_out(); });
  connect(browser_, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(in_browser()); });
  lay_out();
}

void help_panel::set_operations(const QString& markdown) {
  if (std::exchange(operations_, markdown) == markdown)
    return;  // Who reads it stays where they are.
  if (shown() == "operations")
    lay_out();
}

QTextBrowser* help_panel::page() const {
  return page_;
}

QString help_panel::shown() const {
  return pages_->currentData().toString();
}

QUrl help_panel::in_browser() const {
  const QString file = shared_folder() + "/doc/tedit/html/" + shown() + ".html";
  return QFile::exists(file) ? QUrl::fromLocalFile(file) : QUrl();
}

void help_panel::show_page(const QString& id, const QString& heading) {
  const int index = pages_->findData(id);
  if (index < 0)
    return;
  pages_->setCurrentIndex(index);
  auto place = QTextCursor(page_->document());
  for (auto block = page_->document()->begin(); !heading.isEmpty() && block.isValid();
       block = block.next())
    if (block.blockFormat().headingLevel() > 0 && block.text() == heading)
      place = QTextCursor(block);
  page_->setTextCursor(place);
  page_->hold(place);
}

void help_panel::lay_out() {
  page_->let_go();
  page_->setMarkdown(shown() == "operations" ? operations_ : text_of(shown()));
  page_->document()->setIndentWidth(list_indent);
  for (auto* frame : page_->document()->rootFrame()->childFrames())
    if (auto* table = qobject_cast<QTextTable*>(frame)) {
      auto format = table->format();
      format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
      format.setCellPadding(3);
      table->setFormat(format);
    }
  for (auto block = page_->document()->begin(); block.isValid(); block = block.next()) {
    auto format = block.blockFormat();  // Lines of code, too: the panel is narrow.
    format.setNonBreakableLines(false);
    QTextCursor(block).setBlockFormat(format);
  }
  browser_->setVisible(!in_browser().isEmpty());
  search(letters_->text());
}

void help_panel::start_typing() {
  letters_->setFocus();
  letters_->selectAll();
}

void help_panel::search(const QString& letters) {
  if (letters_->text() != letters) {
    letters_->setText(letters);  // Comes back here.
    return;
  }
  hits_.clear();
  at_ = 0;
  if (letters.trimmed().size() >= 2)
    for (QTextCursor found = page_->document()->find(letters); !found.isNull();
         found = page_->document()->find(letters, found))
      hits_ << found;
  show_hit();
}

void help_panel::step(bool back) {
  if (hits_.isEmpty())
    return;
  const auto count = static_cast<int>(hits_.size());
  at_ = (at_ + (back ? count - 1 : 1)) % count;
  show_hit();
}

void help_panel::show_hit() {
  const bool asked = letters_->text().trimmed().size() >= 2;
  count_->setText(hits_.isEmpty() ? (asked ? tr("not found") : QString())
                                  : tr("%1 of %2").arg(at_ + 1).arg(hits_.size()));
  mark_hits();
  if (hits_.isEmpty())
    return;
  page_->let_go();
  auto place = hits_[at_];
  place.clearSelection();  // The mark shows it; a selection would hide its colour.
  page_->setTextCursor(place);
  page_->ensureCursorVisible();
}

void help_panel::mark_hits() {
  QList<QTextEdit::ExtraSelection> marks;
  for (int i = 0; i < static_cast<int>(hits_.size()); ++i) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = hits_[i];
    mark.format.setBackground(i == at_ ? QColor(255, 160, 60) : QColor(255, 226, 150));
    mark.format.setForeground(QColor(20, 24, 30));
    marks << mark;
  }
  page_->setExtraSelections(marks);
}

}  // namespace tedit::desktop
