// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/results_summary/report_file.hpp"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>
#include <QUrl>

namespace tedit::desktop {

namespace {

constexpr int dots_per_inch = 300;
constexpr double margin_mm = 18;
constexpr double foot_inches = 0.35;

QString picture_name(std::size_t i) {
  return QString("picture:%1").arg(i);
}

void set_up(QTextDocument& text, QPdfWriter& writer, const report_facts& facts,
            const QSizeF& page) {
  text.documentLayout()->setPaintDevice(&writer);
  text.setDocumentMargin(0);
  text.setDefaultFont(QFont("sans-serif", 10));
  for (std::size_t i = 0; i < facts.pictures.size(); ++i)
    text.addResource(QTextDocument::ImageResource, QUrl(picture_name(i)),
                     QImage::fromData(facts.pictures[i].png));
  text.setHtml(report_html(facts, picture_name));
  text.setPageSize(page);
}

/// Black on white, whatever the window looks like.
void draw_page(QPainter& painter, const QTextDocument& text, int page) {
  const QSizeF size = text.pageSize();
  const QRectF part(0, page * size.height(), size.width(), size.height());
  QAbstractTextDocumentLayout::PaintContext context;
  context.palette.setColor(QPalette::Text, Qt::black);
  context.clip = part;
  painter.save();
  painter.translate(0, -part.top());
  painter.setClipRect(part);
  text.documentLayout()->draw(&painter, context);
  painter.restore();
}

bool write_pdf(QIODevice& file, const report_facts& facts) {
  QPdfWriter writer(&file);
  writer.setResolution(dots_per_inch);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm),
                        QPageLayout::Millimeter);
  writer.setTitle(facts.title);
  writer.setCreator(facts.program);
  const QSizeF whole = writer.pageLayout().paintRectPixels(dots_per_inch).size();
  const double foot = foot_inches * dots_per_inch;
  QTextDocument text;
  set_up(text, writer, facts, {whole.width(), whole.height() - foot});
  QPainter painter;
  if (!painter.begin(&writer))
    return false;
  for (int i = 0; i < text.pageCount(); ++i) {
    if (i > 0 && !writer.newPage())
      return false;
    draw_page(painter, text, i);
    painter.setFont(QFont("sans-serif", 8));
    painter.setPen(QColor(92, 102, 115));
    const QRectF line(0, whole.height() - foot, whole.width(), foot);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignBottom,
                     QString("%1, %2").arg(facts.title, facts.program));
    painter.drawText(
      line, Qt::AlignRight | Qt::AlignBottom,
      QCoreApplication::translate("report", "Page %1 of %2").arg(i + 1).arg(text.pageCount()));
  }
  return painter.end();
}

}  // namespace

expected<void> write_report_file(const report_facts& facts, const QString& path) {
  const bool pdf = path.endsWith(".pdf", Qt::CaseInsensitive);
  if (!pdf && !path.endsWith(".html", Qt::CaseInsensitive) &&
      !path.endsWith(".htm", Qt::CaseInsensitive))
    return fail(ec::invalid_argument, "a report is a PDF or an HTML file",
                "Choose a name that ends with .pdf or .html", path.toStdString());
  QSaveFile file(path);
  bool written = file.open(QIODevice::WriteOnly);
  if (written && pdf) {
    written = write_pdf(file, facts);
  } else if (written) {
    const QByteArray html = self_contained_html(facts).toUtf8();
    written = file.write(html) == html.size();
  }
  if (!written || !file.commit())
    return fail(ec::io_error, "cannot write the report: " + file.errorString().toStdString(),
                "Choose another folder, or make room there", path.toStdString());
  return {};
}

}  // namespace tedit::desktop
