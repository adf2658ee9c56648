// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/number_option.hpp"

namespace tedit::cli {

/// How a command solves.
struct solver_options {
  std::string device = "auto";
  double tolerance = 1e-6;  ///< True relative residual.
  int order = 2;            ///< Of the tets.
};

inline void add_device_option(CLI::App& command, std::string& device) {
  command
    .add_option("--device", device,
                "cpu, lavapipe, auto (the fastest by a short trial) or part of a device's name")
    ->capture_default_str();
}

/// The options --device, --tolerance and --order. @param options outlives the command.
inline void add_solver_options(CLI::App& command, solver_options& options) {
  add_device_option(command, options.device);
  command.add_option("--tolerance", options.tolerance, "True relative residual to reach")
    ->check(number_in({1e-12, 1e-1, {}}))
    ->capture_default_str();
  command
    .add_option("--order", options.order,
                "2: quadratic tets; 1: linear tets, a quick preview that is too stiff in bending")
    ->check(CLI::IsMember({1, 2}))
    ->capture_default_str();
}

}  // namespace tedit::cli
