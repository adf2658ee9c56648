// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/permissions.hpp"

namespace tedit::gateway {

/// Without a default: the compiler names a kind of request that was forgotten.
access_role least_role(const v1::ClientMessage& message) {
  switch (message.body_case()) {
    // What is there is looked at. Several of these cost work, but change nothing for others.
    case v1::ClientMessage::kHello:
    case v1::ClientMessage::kListOperations:
    case v1::ClientMessage::kCancel:
    case v1::ClientMessage::kGetStatus:
    case v1::ClientMessage::kListDocuments:
    case v1::ClientMessage::kCloseDocument:
    case v1::ClientMessage::kExportFile:
    case v1::ClientMessage::kGetHistory:
    case v1::ClientMessage::kSelectSurfaces:
    case v1::ClientMessage::kCutSection:
    case v1::ClientMessage::kWatchFields:
    case v1::ClientMessage::kGetSurface:
    case v1::ClientMessage::kCompareVersions:
    case v1::ClientMessage::kCheckPrint:
      return access_role::view;
    // Without a name it makes a document.
    case v1::ClientMessage::kOpenDocument:
      return message.open_document().name().empty() ? access_role::edit : access_role::view;
    // Others see what comes of it, or wait for it.
    case v1::ClientMessage::kUploadChunk:
    case v1::ClientMessage::kImportMesh:
    case v1::ClientMessage::kSetLoadCase:
    case v1::ClientMessage::kApplyEdit:
    case v1::ClientMessage::kUndo:
    case v1::ClientMessage::kRedo:
    case v1::ClientMessage::kSolve:
    case v1::ClientMessage::kGoToVersion:
    case v1::ClientMessage::kPreviewEdit:
    case v1::ClientMessage::kAnnotateVersion:
    case v1::ClientMessage::kRemoveLoadCase:
    case v1::ClientMessage::kCancelSolve:
    case v1::ClientMessage::kAddDocument:
    case v1::ClientMessage::kImportPart:
    case v1::ClientMessage::kRenameDocument:
    case v1::ClientMessage::kCopyDocument:
      return access_role::edit;
    // Nobody can take it back, and documents have no owner who could be asked.
    case v1::ClientMessage::kDeleteDocument:
      return access_role::admin;
    case v1::ClientMessage::BODY_NOT_SET:
      break;  // Refused as unknown.
  }
  return access_role::view;
}

expected<void> check_role(access_role has, const v1::ClientMessage& message) {
  const auto needed = least_role(message);
  if (has >= needed)
    return {};
  return fail(ec::permission_denied,
              "this needs the role " + std::string(name_of(needed)) + ", and your token has " +
                std::string(name_of(has)),
              "Ask who keeps the server for another role (tedit users role)");
}

}  // namespace tedit::gateway
