// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/tour/tour_tool.hpp"

#include <algorithm>
#include <cmath>

#include "client-qt/context/command_groups.hpp"
#include "client-qt/tools/documents/documents_tool.hpp"
#include "client-qt/tools/documents/welcome_page.hpp"
#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/tour/tour_card.hpp"

namespace tedit::desktop {

namespace {

constexpr QPoint card_place{12, 12};
constexpr surface_id bore_of_the_plate = 1;

/// Whether it is looked at from another side.
bool has_turned(const camera::pose& before, const camera::pose& now) {
  const vec3 a = before.position - before.focus;
  const vec3 b = now.position - now.focus;
  return dot(a, b) < 0.999 * std::sqrt(dot(a, a) * dot(b, b));
}

}  // namespace

tour_tool::tour_tool(window_context& in, documents_tool& documents, context_panel& operations)
    : in_(in), documents_(documents), operations_(operations), card_(new tour_card(&in.view)) {
  card_->move(card_place);
  make_steps();
  wire();
  in_.all_commands.add({"help.tour",
                        tr("Take the tour"),
                        command_groups::help(),
                        {},
                        [this] { start(); },
                        {},
                        tr("Two minutes on a shipped part: close a bore and see its stress")});
}

void tour_tool::make_steps() {
  const auto run = [this](const char* command) {
    return [this, command] { (void)in_.all_commands.trigger(command); };
  };
  steps_ = {{tr("Turn the part"),
             tr("Drag with the left mouse button. The wheel zooms to the pointer, F "
                "puts the whole part back into the view."),
             [this] { return has_turned(pose_, in_.view.view().get()); },
             [this] {
               in_.view.view().rotate(0.15, 0.08);
               in_.view.redraw();
               emit in_.view.view_changed();
             }},
            {tr("Pick a bore"),
             tr("Click into one of the holes: all of its wall is selected. At the right "
                "stands what it is, and what can be done with it."),
             [this] { return !in_.picked.surfaces().empty(); },
             [this] { in_.picked.click(bore_of_the_plate, false); }},
            {tr("Close it"),
             tr("Choose Fill hole. The preview shows what comes (orange) before anything "
                "is changed; where the part stays as it is, its stress stays in sight."),
             [this] { return operations_.chosen() == "fill_hole"; },
             [this] { operations_.choose("fill_hole"); }},
            {tr("Apply"),
             tr("Press Apply, or Ctrl+Enter. Loads and supports stay where they are, and the "
                "stress is solved anew by itself."),
             [this] { return in_.part.head()->info.number != version_; }, run("edit.apply")},
            {tr("Read the result"),
             tr("The line at the bottom says \"preview\" until the stress is final. "
                "Press R: the largest stress, before and after."),
             [this] { return command_ == "view.results"; }, run("view.results")},
            {tr("Take it back"),
             tr("Ctrl+Z undoes, Ctrl+Y brings it back. Every version stays in the "
                "history below, and nothing has to be saved."),
             [this] { return in_.part.head()->info.number != version_; }, run("edit.undo")},
            {tr("That is all"),
             tr("Ctrl+K finds every command by its name, F1 is the manual. Drop a mesh "
                "of your own on the window to go on."),
             {},
             {}}};
}

void tour_tool::wire() {
  connect(card_, &tour_card::close_wanted, this, &tour_tool::end);
  connect(card_, &tour_card::skip_wanted, this, [this] { begin_step(at_ + 1); });
  connect(card_, &tour_card::show_me_wanted, this, [this] { steps_[at_].show_me(); });
  connect(&in_.view, &viewport::view_changed, this, &tour_tool::look);
  connect(&in_.picked, &selection::changed, this, &tour_tool::look);
  connect(&operations_, &context_panel::form_opened, this, &tour_tool::look);
  connect(&in_.part, &document::head_changed, this, &tour_tool::look);
  connect(&in_.all_commands, &commands::triggered, this, [this](const QString& id) {
    command_ = id;
    look();
  });
  connect(&in_.part, &document::opened, this, [this] {
    if (std::exchange(opens_, false))
      begin_step(0);
    else
      end();
  });
  connect(&in_.part, &document::closed, this, &tour_tool::end);
  in_.esc.add(ends::tour, [this] {
    const bool shown = at_ >= 0;
    end();
    return shown;
  });
}

void tour_tool::start() {
  const auto all = shipped_examples();
  const auto plate =
    std::ranges::find_if(all, [](const example& one) { return one.mesh.contains("ctc01_plate"); });
  if (plate == all.end())
    return in_.messages.show_news(tr("The shipped parts are not there: the tour needs the plate."));
  end();
  opens_ = true;
  documents_.open_file(plate->mesh, plate->load_cases);
}

void tour_tool::end() {
  at_ = -1;
  card_->hide();
}

void tour_tool::begin_step(int number) {
  if (number >= steps())
    return end();
  at_ = number;
  pose_ = in_.view.view().get();
  version_ = in_.part.head() ? in_.part.head()->info.number : 0;
  command_.clear();
  const auto& now = steps_[number];
  card_->show_step(now.title, now.words, number + 1, steps());
  look();
}

void tour_tool::look() {
  if (at_ >= 0 && in_.part.head() && steps_[at_].done && steps_[at_].done())
    begin_step(at_ + 1);
}

}  // namespace tedit::desktop
