// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/loads/unfinished_forms.hpp"

#include "client-qt/model/document.hpp"
#include "client-qt/model/selection.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

/// An item has no name of its own, and its place changes with those before it: it is told by what
/// it says.
void unfinished_forms::open(const load_editor& form, const std::string& load_case, item_kind kind,
                            const std::optional<load_item>& item) {
  leave(form);
  fem::load_case only;
  only.name = load_case;
  if (item)
    put(only, *item);
  open_ = std::to_string(static_cast<int>(kind)) + protocol::load_case_to_json(only);
  is_new_ = !item;
}

void unfinished_forms::leave(const load_editor& form) {
  auto typed = open_ ? form.typed() : std::nullopt;
  if (typed)
    typed_[*open_] = std::move(*typed);
  open_.reset();
}

void unfinished_forms::forget() {
  if (open_)
    typed_.erase(*open_);
  open_.reset();
}

void unfinished_forms::clear() {
  open_.reset();
  typed_.clear();
}

void unfinished_forms::take_up(load_editor& form, selection& picked, const document& part) const {
  const auto found = typed_.find(open_.value_or(std::string()));
  if (found == typed_.end())
    return;
  form.take_up(found->second);
  auto surfaces = found->second.surfaces;
  if (const auto* head = part.head(); head && head->surface)
    std::erase_if(surfaces, [&](surface_id id) { return !head->surface->surfaces().contains(id); });
  if (!is_new_ || picked.surfaces().empty())
    picked.set(std::move(surfaces));
}

}  // namespace tedit::desktop
