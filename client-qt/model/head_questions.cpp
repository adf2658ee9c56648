// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/head_questions.hpp"

#include <utility>

#include "client-qt/model/document.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

/// The surface is made aside, too: a copy of the head's with the difference.
ticket head_questions::preview(const edit_wish& wish, client::preview_kind kind,
                               remote::reply<shared_preview> done,
                               const remote::progress& advanced) {
  const auto* now = part_.head();
  const auto before = now ? now->surface : nullptr;
  return link_.run<shared_preview>(
    [=, id = wish.operation.toStdString()](client::client& c,
                                           const execution& run) -> expected<shared_preview> {
      if (!before)
        return fail(ec::superseded, "the part is not here yet");
      auto got =
        c.preview_edit(id, wish.surfaces, wish.values, run, before->version_id(), wish.loads, kind);
      if (!got)
        return fail(std::move(got.error()));
      auto surface = std::make_shared<client::surface_model>(*before);
      if (auto ok = surface->apply(got->surface); !ok)
        return fail(std::move(ok.error()));
      got->surface = {};
      return std::make_shared<const shown_preview>(
        shown_preview{std::move(*got), before, std::move(surface)});
    },
    std::move(done), advanced);
}

void head_questions::select(const selection_query& query,
                            remote::reply<std::vector<found_feature>> done) {
  link_.run<std::vector<found_feature>>(
    [query](client::client& c, const execution& run) { return c.select(query, run); },
    std::move(done));
}

void head_questions::surface_of(std::uint32_t number, remote::reply<shared_surface> done) {
  link_.run<shared_surface>(
    [number](client::client& c, const execution& run) -> expected<shared_surface> {
      auto got = c.surface_of(number, run);
      if (!got)
        return fail(std::move(got.error()));
      return std::make_shared<const client::surface_model>(std::move(*got));
    },
    std::move(done));
}

void head_questions::compare(std::uint32_t before, std::uint32_t after,
                             const std::string& load_case, remote::reply<shared_comparison> done) {
  link_.run<shared_comparison>(
    [=](client::client& c, const execution& run) -> expected<shared_comparison> {
      auto got = c.compare(before, after, load_case, run);
      if (!got)
        return fail(std::move(got.error()));
      return std::make_shared<const client::comparison>(std::move(*got));
    },
    std::move(done));
}

template <class T>
std::function<void()> head_questions::ask_listed(const QString& title, remote::work<T> call,
                                                 remote::reply<T> done) {
  struct question {
    int job = 0;
    ticket asked;
    remote::reply<T> done;
  };
  auto& all = part_.work();
  auto open = std::make_shared<question>();
  const auto finish = [&all, open](expected<T> got) {
    all.end(open->job);
    if (auto then = std::exchange(open->done, nullptr))
      then(std::move(got));
  };
  const auto cancel = [open, finish] {
    open->asked.cancel();
    finish(fail(ec::cancelled, "the question was cancelled"));
  };
  open->done = std::move(done);
  open->job = all.begin(title, cancel);
  open->asked =
    link_.run<T>(std::move(call), finish, [&all, open](double fraction, const QString& stage) {
      all.progress(open->job, fraction, words_of(stage.toStdString()));
    });
  return cancel;
}

void head_questions::cut(const vec3& at, const vec3& normal, const std::string& load_case,
                         remote::reply<client::section> done) {
  ask_listed<client::section>(
    tr("Section"),
    [=](client::client& c, const execution& run) { return c.cut(at, normal, load_case, run); },
    std::move(done));
}

std::function<void()> head_questions::check_print(const print_settings& settings,
                                                  std::uint32_t number,
                                                  remote::reply<shared_print_check> done) {
  return ask_listed<shared_print_check>(
    tr("Check for printing"),
    [=](client::client& c, const execution& run) -> expected<shared_print_check> {
      auto got = c.check_print(settings, number, run);
      if (!got)
        return fail(std::move(got.error()));
      return std::make_shared<const client::print_check>(std::move(*got));
    },
    std::move(done));
}

}  // namespace tedit::desktop
