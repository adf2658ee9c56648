// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/widgets/theme.hpp"

#include <QFile>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>

/// The drawings lie in a static library, which the linker would not start. Outside any namespace,
/// as Qt's macro wants it.
static void load_resources() {
  Q_INIT_RESOURCE(client);
}

namespace tedit::desktop {

namespace {

// A dock's title is as high as its letters and twice the room above them: the line below it takes
// its pixel from the room there, else from the letters.
constexpr auto sheet = R"(
QToolTip { color: %TEXT%; background: %PANEL%; border: 1px solid %LINE%; padding: 4px; }
QMainWindow::separator { background: %LINE%; width: 1px; height: 1px; }
QToolBar { border: 0; background: %PANEL%; spacing: 4px; padding: 3px; }
QToolButton { border: 0; border-radius: 5px; padding: 5px; }
QToolButton:hover { background: %HOVER%; }
QToolButton:checked, QToolButton:pressed { background: %PRESSED%; }
QToolButton:focus { background: %HOVER%; }
QDockWidget { titlebar-close-icon: none; titlebar-normal-icon: none; font-weight: 600; }
QDockWidget::title { background: %PANEL%; padding: 6px 8px 4px 8px; border-bottom: 1px solid %LINE%; }
QStatusBar { background: %PANEL%; border-top: 1px solid %LINE%; }
QStatusBar::item { border: 0; }
QPushButton { border: 1px solid %LINE%; border-radius: 5px; padding: 5px 14px; background: %BUTTON%;
  outline: 0; }
QPushButton:hover { background: %HOVER%; }
QPushButton:checked { background: %PRESSED%; border-color: %ACCENT%; }
QPushButton:focus { border-color: %ACCENT%; }
QPushButton:disabled { color: %FAINT%; }
QPushButton[role="primary"] { background: %ACCENT%; color: white; border-color: %ACCENT%; font-weight: 600; }
QPushButton[role="primary"]:disabled { background: %LINE%; border-color: %LINE%; color: %FAINT%; }
QPushButton[role="link"] { border: 0; background: transparent; color: %LINK%; padding: 2px; text-align: left; }
QPushButton[role="link"]:disabled { color: %FAINT%; }
QPushButton[role="link"]:hover { text-decoration: underline; }
QLineEdit { border: 1px solid %LINE%; border-radius: 5px; padding: 3px 6px; background: %FIELD%; }
QLineEdit[role="search"] { padding: 4px 6px; }
QLineEdit:focus { border-color: %ACCENT%; }
QAbstractSpinBox QLineEdit, QComboBox QLineEdit { border: 0; padding: 0; }
QCheckBox::indicator:unchecked { width: 12px; height: 12px; border: 1px solid %FAINT%; border-radius: 3px;
  background: %FIELD%; }
QCheckBox::indicator:checked { width: 12px; height: 12px; border: 1px solid %ACCENT%; border-radius: 3px;
  background: %ACCENT%; image: url(:/icons/tick.svg); }
QCheckBox::indicator:checked:disabled { border-color: %FAINT%; background: %FAINT%; }
QPlainTextEdit { border: 0; background: %FIELD%; }
QTextBrowser { border: 0; background: %PANEL%; padding: 6px; }
QListView, QTreeView { border: 0; background: %PANEL%; outline: 0; }
QListView::item, QTreeView::item { padding: 3px; }
QListView::item:selected, QTreeView::item:selected { background: %PRESSED%; color: %TEXT%; }
QFrame#jobs_panel, QFrame#finder, QFrame#palette, QFrame#section_bar, QFrame#tour_card {
  border: 1px solid %LINE%; background: %PANEL%; }
QProgressBar { border: 0; border-radius: 3px; background: %LINE%; max-height: 6px; }
QProgressBar::chunk { background: %ACCENT%; border-radius: 3px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QLabel[role="title"] { font-size: 15px; font-weight: 600; }
QLabel[role="section"] { font-weight: 600; padding-top: 6px; qproperty-indent: 0; }
QLabel[role="faint"] { color: %FAINT%; }
QLabel[role="fault"] { color: %FAULT%; }
)";

struct tones {
  QColor window, panel, field, text, faint, line, hover, pressed, button, accent, link, fault;
};

QString filled(QString text, const tones& t) {
  const std::pair<const char*, QColor> marks[] = {
    {"%TEXT%", t.text},       {"%PANEL%", t.panel},   {"%LINE%", t.line},     {"%HOVER%", t.hover},
    {"%PRESSED%", t.pressed}, {"%BUTTON%", t.button}, {"%ACCENT%", t.accent}, {"%FAINT%", t.faint},
    {"%FIELD%", t.field},     {"%LINK%", t.link},     {"%FAULT%", t.fault}};
  for (const auto& [mark, colour] : marks)
    text.replace(mark, colour.name());
  return text;
}

QPalette palette_of(const tones& t) {
  QPalette p;
  p.setColor(QPalette::Window, t.panel);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Base, t.field);
  p.setColor(QPalette::AlternateBase, t.panel);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::Button, t.button);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::ToolTipBase, t.panel);
  p.setColor(QPalette::ToolTipText, t.text);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, Qt::white);
  p.setColor(QPalette::PlaceholderText, t.faint);
  p.setColor(QPalette::Link, t.link);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, t.faint);
  return p;
}

}  // namespace

theme make_theme(bool dark) {
  theme result;
  result.dark = dark;
  const tones t = dark ? tones{"#1b1f24", "#23282f", "#1a1e23", "#e6e9ee", "#8f98a5", "#39414b",
                               "#2f3640", "#3a434f", "#2b313a", "#d9742b", "#6db3f2", "#ff6b6b"}
                       : tones{"#ffffff", "#f6f7f9", "#ffffff", "#20262e", "#6a7482", "#d5dae1",
                               "#e8ecf1", "#dbe2ea", "#ffffff", "#c8641c", "#1f6fb2", "#c62828"};
  result.palette = palette_of(t);
  result.style_sheet = filled(sheet, t);
  result.ink = t.text;
  result.frame = t.line;
  result.cube = t.panel;
  result.good = dark ? "#4cc38a" : "#1c8a55";
  result.warning = dark ? "#e5b454" : "#9a6700";
  result.error = dark ? "#ff6b6b" : "#c62828";
  if (dark) {
    result.scene.low = {0.10F, 0.12F, 0.14F};
    result.scene.high = {0.21F, 0.24F, 0.28F};
    result.scene.part = {0.55F, 0.58F, 0.62F};
    result.scene.edges = {0.05F, 0.06F, 0.07F};
  }
  return result;
}

namespace {

QByteArray read_icon(const QString& name) {
  load_resources();
  QFile file(":/icons/" + name + ".svg");
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A plugin's drawing comes from a server: it may not reach for files, nor be large.
bool is_plain_drawing(const QString& text) {
  constexpr qsizetype longest = 8 * 1024;
  static const QRegularExpression reaches("href|<!|<script|<style|url\\(|@import",
                                          QRegularExpression::CaseInsensitiveOption);
  return text.startsWith("<svg") && text.size() <= longest && !text.contains(reaches);
}

QByteArray drawing_of(const QString& name_or_svg) {
  if (is_plain_drawing(name_or_svg))
    return name_or_svg.toUtf8();
  const auto known = name_or_svg.startsWith('<') ? QByteArray() : read_icon(name_or_svg);
  return known.isEmpty() ? read_icon("operation") : known;
}

}  // namespace

QIcon icon(const QString& name_or_svg, const QColor& ink) {
  QIcon result;
  const QByteArray drawing = drawing_of(name_or_svg);
  for (const auto mode : {QIcon::Normal, QIcon::Disabled}) {
    QColor colour = ink;
    if (mode == QIcon::Disabled)
      colour.setAlphaF(0.35F);
    QByteArray tinted = drawing;
    tinted.replace("#000", colour.name().toUtf8());
    QSvgRenderer renderer(tinted);
    for (const int size : {20, 24, 40, 48}) {
      QPixmap pixels(size, size);
      pixels.fill(Qt::transparent);
      QPainter painter(&pixels);
      painter.setOpacity(colour.alphaF());
      renderer.render(&painter);
      result.addPixmap(pixels, mode);
    }
  }
  return result;
}

QIcon window_icon() {
  load_resources();
  return QIcon(":/tedit.svg");
}

}  // namespace tedit::desktop
