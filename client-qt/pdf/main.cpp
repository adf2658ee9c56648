// SPDX-License-Identifier: AGPL-3.0-or-later
// A report's page as PDF, A4 across with page numbers; of "tedit run --report FILE.pdf". It needs
// no display. usage: tedit-pdf PAGE.html FILE.pdf
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <cstdio>

namespace {

/// A document whose pictures lie in the page itself.
class page_document : public QTextDocument {
protected:
  QVariant loadResource(int type, const QUrl& name) override {
    const auto text = name.toString();
    const QString picture = "data:image/png;base64,";
    if (type == QTextDocument::ImageResource && text.startsWith(picture))
      return QByteArray::fromBase64(text.mid(picture.size()).toLatin1());
    return {};  // Nothing from elsewhere.
  }
};

/// The page's lengths are those of screens, 96 to the inch; what is drawn is as fine as paper.
void print(QTextDocument& document, QFile& out) {
  constexpr double screen_dpi = 96;
  constexpr int margin = 44;
  constexpr int usual_text = 13;
  QPdfWriter pdf(&out);
  pdf.setPageSize(QPageSize(QPageSize::A4));
  pdf.setPageOrientation(QPageLayout::Landscape);
  pdf.setPageMargins({});
  pdf.setTitle(document.metaInformation(QTextDocument::DocumentTitle));
  pdf.setCreator("TEdit");
  const double scale = pdf.resolution() / screen_dpi;
  const QSizeF paper = QSizeF(pdf.width(), pdf.height()) / scale;
  QFont font;
  font.setPixelSize(usual_text);
  document.setDefaultFont(font);
  document.setDocumentMargin(0);
  const QSizeF area(paper.width() - 2 * margin, paper.height() - 2 * margin);
  document.setPageSize(area);
  QPainter painter(&pdf);
  painter.scale(scale, scale);
  for (int page = 0; page < document.pageCount(); ++page) {
    if (page > 0)
      pdf.newPage();
    const QRectF shown(QPointF(0, page * area.height()), area);
    painter.save();
    painter.translate(margin, margin - shown.top());
    document.drawContents(&painter, shown);
    painter.restore();
    painter.setFont(font);
    painter.drawText(QRectF(margin, paper.height() - margin, area.width(), margin),
                     Qt::AlignRight | Qt::AlignVCenter,
                     QString("%1 / %2").arg(page + 1).arg(document.pageCount()));
  }
}

int refuse(const QString& why) {
  std::fprintf(stderr, "tedit-pdf: %s\n", why.toUtf8().constData());
  return 1;
}

int write(const QString& page, const QString& file) {
  QFile in(page);
  if (!in.open(QIODevice::ReadOnly))
    return refuse(page + ": " + in.errorString());
  page_document document;
  document.setHtml(QString::fromUtf8(in.readAll()));
  QFile out(file);
  if (!out.open(QIODevice::WriteOnly))
    return refuse(file + ": " + out.errorString());
  print(document, out);
  if (!out.flush() || out.error() != QFileDevice::NoError)
    return refuse(file + ": " + out.errorString());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication app(argc, argv);
  const auto arguments = QGuiApplication::arguments();
  if (arguments.size() != 3) {
    std::fprintf(stderr, "usage: tedit-pdf PAGE.html FILE.pdf\n");
    return 2;
  }
  return write(arguments[1], arguments[2]);
}
