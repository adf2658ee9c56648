// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/print_inspection.hpp"

#include <utility>

namespace tedit::desktop {

print_inspection::print_inspection(document& part) : part_(part) {
  connect(&part_, &document::head_changed, this, &print_inspection::follow);
  connect(&part_, &document::opened, this, &print_inspection::follow);
  for (auto signal : {&document::begun, &document::closed})
    connect(&part_, signal, this, &print_inspection::stop);
}

void print_inspection::look(const print_settings& settings) {
  wanted_ = settings;
  ask();
}

void print_inspection::stop() {
  const bool was_on = std::exchange(wanted_, std::nullopt).has_value();
  forget();
  if (was_on)
    emit changed();
}

void print_inspection::cancel() {
  if (const auto end = std::exchange(end_question_, nullptr))
    end();
}

/// The head may be told of again as it was: then all stays.
void print_inspection::follow() {
  const auto* head = part_.head();
  if (wanted_ && asked_of_ != (head ? head->info.version_id : std::string()))
    ask();
}

void print_inspection::forget() {
  ++question_;
  cancel();
  asking_ = false;
  asked_of_.clear();
  known_.reset();
  refusal_.reset();
}

void print_inspection::ask() {
  forget();
  if (const auto* head = part_.head()) {
    asked_of_ = head->info.version_id;
    asking_ = true;
    auto end = part_.questions().check_print(
      *wanted_, head->info.number, [this, mine = question_](expected<shared_print_check> got) {
        if (mine == question_)
          take(std::move(got));
      });
    if (asking_)  // Without a connection it is answered by now.
      end_question_ = std::move(end);
  }
  emit changed();
}

void print_inspection::take(expected<shared_print_check> got) {
  asking_ = false;
  end_question_ = nullptr;
  if (!got)
    refusal_ = got.error();
  else if ((*got)->version_id == asked_of_)
    known_ = std::move(*got);
  emit changed();
}

}  // namespace tedit::desktop
