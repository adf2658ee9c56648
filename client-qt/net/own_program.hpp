// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::desktop {

/// Runs this installation's `tedit`, on this computer, and gives the object that it prints; one
/// without "error" may also come from a command that found something wrong (exit status 1). It
/// waits: for a thread of work. Errors: those that the program says; `cancelled`;
/// `service_unavailable` where it does not start or says nothing.
[[nodiscard]] expected<QJsonObject> run_own_program(const QStringList& arguments,
                                                    const execution& run);

/// Puts the bytes of a document into a file of the folder and gives its path. Errors: `io_error`,
/// also where there is no such folder.
[[nodiscard]] expected<QString> keep_document(const QTemporaryDir& folder,
                                              const std::vector<char>& bytes);

}  // namespace tedit::desktop
