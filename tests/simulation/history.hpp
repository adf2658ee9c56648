// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tedit::simulation {

/// The head of a document as a client heard of it.
struct seen_head {
  std::uint32_t number = 0;
  std::string version;
  std::string cause;
};

/// What one client saw of a document from its opening to the end of its connection.
struct watch {
  std::string client;
  std::string document;                ///< By its present name.
  std::optional<std::uint32_t> first;  ///< The head when it was opened.
  std::vector<seen_head> moves;
  bool to_the_end = false;      ///< It was still connected.
  std::set<std::uint32_t> cad;  ///< Versions whose state on the CAD model it was told.
};

/// What clients asked for and were told, and whatever is wrong with that at once.
struct history {
  /// By edit id: the head that an acknowledged change led to; nothing for one that moves no head.
  std::map<std::string, std::optional<seen_head>> acknowledged;
  std::map<std::string, std::string> refused;  ///< By edit id: the last error's code.
  std::vector<watch> watches;
  std::map<std::string, int> copied;   ///< By name: how many copies were acknowledged.
  std::map<std::string, int> deleted;  ///< By name: how many deletions were acknowledged.
  std::map<std::string, int> errors;   ///< By code: how many requests.
  std::map<int, int> cad;              ///< By `v1::CadState::Status`: how many states were told.
  std::vector<std::string> faults;     ///< What must not happen, and did.
  std::uint64_t answers = 0;
};

}  // namespace tedit::simulation
