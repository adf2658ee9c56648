// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/operation_log.hpp"

#include <algorithm>
#include <memory>
#include <mutex>

namespace tedit::ops {

namespace {

constexpr std::size_t most_characters = 2000;
constexpr std::size_t most_lines = 200;

class edit_log {
public:
  edit_log(std::string operation, std::function<void(const std::string&)> sink)
      : prefix_(std::move(operation) + ": "), sink_(std::move(sink)) {}

  void take(std::string_view text) {
    const std::lock_guard lock(mutex_);
    while (!text.empty() && lines_ <= most_lines) {
      const auto line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), line.size() + 1));
      add(std::string(line.substr(0, most_characters)));
    }
  }

private:
  void add(std::string line) {
    if (++lines_ > most_lines)
      line = "(it logs more than " + std::to_string(most_lines) + " lines: the rest is left out)";
    std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
    sink_(prefix_ + line);
  }

  std::string prefix_;
  std::function<void(const std::string&)> sink_;
  std::mutex mutex_;
  std::size_t lines_ = 0;
};

}  // namespace

std::function<void(std::string_view)> operation_log(std::string operation,
                                                    std::function<void(const std::string&)> sink) {
  const auto log = std::make_shared<edit_log>(std::move(operation), std::move(sink));
  return [log](std::string_view text) { log->take(text); };
}

}  // namespace tedit::ops
