// SPDX-License-Identifier: AGPL-3.0-or-later
// A report's page as PDF, A4 across with page numbers; of "tedit run --report FILE.pdf". It needs
// no display. usage: tedit-pdf PAGE.html FILE.pdf
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPageLayout>
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
  {
    QPdfWriter pdf(&out);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageOrientation(QPageLayout::Landscape);
    pdf.setTitle(document.metaInformation(QTextDocument::DocumentTitle));
    pdf.setCreator("TEdit");
    document.print(&pdf);
  }
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
