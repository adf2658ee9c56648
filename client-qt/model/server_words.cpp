// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/server_words.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr const char* server_templates[] = {
#include "client-qt/model/server_words.inc"
};

/// What the system says of connections, which a client hands on.
constexpr const char* system_words[] = {
  QT_TRANSLATE_NOOP("server", "Connection refused"),
  QT_TRANSLATE_NOOP("server", "Connection reset by peer"),
  QT_TRANSLATE_NOOP("server", "Connection timed out"),
  QT_TRANSLATE_NOOP("server", "No route to host"),
  QT_TRANSLATE_NOOP("server", "Network is unreachable"),
  QT_TRANSLATE_NOOP("server", "Host not found (authoritative)"),
  QT_TRANSLATE_NOOP("server", "Broken pipe"),
  QT_TRANSLATE_NOOP("server", "End of file"),
};

/// A template whose own words have fewer letters fits by chance, too.
constexpr int telling_letters = 8;
constexpr int deepest = 4;  // Of sentences in sentences.

/// One template, cut at its places.
struct server_form {
  const char* english;
  QStringList
    own;        ///< What stands before, between and behind the places; may be empty at the ends.
  int letters;  ///< In `own`.
};

std::vector<server_form> make_forms() {
  static const QRegularExpression place("%[0-9]");
  std::vector<server_form> result;
  std::vector<const char*> all(std::begin(server_templates), std::end(server_templates));
  all.insert(all.end(), std::begin(system_words), std::end(system_words));
  for (const auto* english : all) {
    const QStringList own = QString::fromUtf8(english).split(place);
    int letters = 0;
    for (const auto& part : own)
      letters += static_cast<int>(
        std::ranges::count_if(part, [](const QChar& one) { return one.isLetter(); }));
    result.push_back({english, own, letters});
  }
  // Who says most comes first: "surface %1 has no room" before "surface %1".
  std::ranges::stable_sort(result, std::ranges::greater{}, &server_form::letters);
  return result;
}

const std::vector<server_form>& server_forms() {
  static const auto all = make_forms();
  return all;
}

/// What stands at the places; nothing when the text was not made from the template.
std::optional<QStringList> places_in(const QString& text, const server_form& form) {
  if (form.own.size() == 1)
    return text == form.own.front() ? std::optional(QStringList()) : std::nullopt;
  const qsizetype end = text.size() - form.own.back().size();
  if (!text.startsWith(form.own.front()) || !text.endsWith(form.own.back()))
    return std::nullopt;
  QStringList result;
  qsizetype at = form.own.front().size();
  for (qsizetype i = 1; i < form.own.size(); ++i) {
    const bool last = i + 1 == form.own.size();
    const qsizetype next = last ? end : text.indexOf(form.own[i], at + 1);
    if (next <= at || next > end)
      return std::nullopt;
    result << text.mid(at, next - at);
    at = next + form.own[i].size();
  }
  return result;
}

bool is_number(const QString& text) {
  static const QRegularExpression form(R"(^[-+(]?[0-9][-+0-9.,e ()%]*( ?[a-zA-Z]{1,3}[23]?)?$)");
  return form.match(text).hasMatch();
}

std::optional<QString> translated(const QString& text, int depth);

/// "translation along x; rotation about the axis y" and the like: nothing unless all are known.
std::optional<QString> translated_list(const QString& text, int depth) {
  static const QRegularExpression between("(, | and |; )(?=[a-z])");
  QString result;
  qsizetype at = 0;
  for (auto all = between.globalMatch(text); all.hasNext();) {
    const auto found = all.next();
    const auto part = translated(text.mid(at, found.capturedStart() - at), depth);
    if (!part)
      return std::nullopt;
    const QString mark = found.captured(1);
    result +=
      *part + (mark == " and " ? QCoreApplication::translate("server_lists", " and ") : mark);
    at = found.capturedEnd();
  }
  const auto last = at > 0 ? translated(text.mid(at), depth) : std::nullopt;
  return last ? std::optional(result + *last) : std::nullopt;
}

/// What stands at a place: sentences of the server, words of operations, kinds of loads, names.
QString place_words_of(const QString& text, int depth, bool& known) {
  if (const auto list = translated_list(text, depth + 1))
    return *list;
  if (const auto sentence = translated(text, depth + 1))
    return *sentence;
  const QByteArray english = text.toUtf8();
  QString capital = text;
  if (!capital.isEmpty())
    capital[0] = capital[0].toUpper();
  for (const char* context : {"operations", "receipt_words"})
    for (const auto& word : {english, capital.toUtf8()})
      if (QString found = QCoreApplication::translate(context, word);
          found != QString::fromUtf8(word))
        return found;
  known = known && is_number(text);
  return text;
}

/// All places at once: what stands at one may have a "%2" in it.
QString filled(const QString& words, const QStringList& places) {
  QString result;
  for (qsizetype i = 0; i < words.size(); ++i) {
    const int number = words[i] == '%' && i + 1 < words.size() ? words[i + 1].digitValue() : -1;
    if (number < 1 || number > places.size()) {
      result += words[i];
      continue;
    }
    result += places[number - 1];
    ++i;
  }
  return result;
}

std::optional<QString> translated(const QString& text, int depth) {
  if (depth > deepest)
    return std::nullopt;
  for (const auto& form : server_forms()) {
    auto places = places_in(text, form);
    if (!places)
      continue;
    const QString words = QCoreApplication::translate("server", form.english);
    if (words == QString::fromUtf8(form.english))
      continue;
    bool known = true;
    for (auto& place : *places)
      place = place_words_of(place, depth, known);
    if (known || form.letters >= telling_letters)
      return filled(words, *places);
  }
  return std::nullopt;
}

/// Of several sentences in a row each by itself; nothing when none is known.
std::optional<QString> by_parts(const QString& text, const QString& between) {
  QStringList parts = text.split(between);
  bool any = false;
  for (auto& part : parts)
    if (const auto words = translated(part, 0)) {
      part = *words;
      any = true;
    }
  return any && parts.size() > 1 ? std::optional(parts.join(between)) : std::nullopt;
}

}  // namespace

QString in_window_language(const std::string& said) {
  QString text = QString::fromStdString(said);
  if (const auto whole = translated(text, 0))
    return *whole;
  for (const char* between : {". ", "; "})
    if (const auto parts = by_parts(text, between))
      return *parts;
  return text;
}

QString one_line(const error& reason) {
  QString text = words_of(reason.message);
  if (!reason.where.empty())
    text += " [" + words_of(reason.where) + "]";
  if (!reason.remedy.empty())
    text += ". " + words_of(reason.remedy);
  return text;
}

}  // namespace tedit::desktop
