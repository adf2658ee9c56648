// SPDX-License-Identifier: AGPL-3.0-or-later
// How a version stands on the CAD model, in words.
#include <gtest/gtest.h>

#include "client-qt/model/cad_words.hpp"

namespace tedit::desktop {
namespace {

using client::cad_status;

client::version_info version(cad_status status, const std::string& reason = {}) {
  client::version_info result;
  result.number = 3;
  result.operation = "thicken";
  result.cad = client::cad_state{status, reason, status == cad_status::same ? 3e-9 : 0};
  return result;
}

TEST(CadWords, SayHowNearTheMeshIsToTheModelOrWhyItIsAlone) {
  EXPECT_EQ(cad_words(version(cad_status::pending)).toStdString(), "Being made on the CAD model");
  EXPECT_EQ(cad_words(version(cad_status::same)).toStdString(),
            "On the CAD model, new vertices within 3e-6 mm");
  EXPECT_EQ(
    cad_words(version(cad_status::mesh_only, "layer, slab: it cannot be done so")).toStdString(),
    "In the mesh only: layer, slab: it cannot be done so");
  EXPECT_EQ(cad_words(version(cad_status::failed, "the disk is full. Make room")).toStdString(),
            "Not tried on the CAD model: the disk is full. Make room");
  auto imported = version(cad_status::same);
  imported.operation = "import";
  EXPECT_EQ(cad_words(imported), "The part as the CAD model has it");
  imported.cad.reset();
  EXPECT_TRUE(cad_words(imported).isEmpty()) << "of a part from a mesh";
}

TEST(CadWords, AreNoNewsButWhereAPersonMayWantToTakeSomethingBack) {
  const auto mesh_only = version(cad_status::mesh_only, "no way was right");
  const client::cad_state same{cad_status::same, {}, 0};
  EXPECT_EQ(cad_news(mesh_only, same), "Version 3. In the mesh only: no way was right");
  EXPECT_TRUE(cad_news(mesh_only, mesh_only.cad).isEmpty()) << "the first one was told";
  EXPECT_TRUE(cad_news(version(cad_status::same), same).isEmpty());
  EXPECT_TRUE(cad_news(version(cad_status::pending), same).isEmpty());
  EXPECT_FALSE(cad_news(version(cad_status::failed, "there is none"), same).isEmpty());
}

TEST(CadWords, OnPicturesAreShortAndNothingForWhatIsNotKnownHere) {
  for (const auto status :
       {cad_status::pending, cad_status::same, cad_status::mesh_only, cad_status::failed}) {
    const auto mark = cad_mark_words({status, {}, 0});
    EXPECT_FALSE(mark.isEmpty());
    EXPECT_LE(mark.size(), 10);
  }
  EXPECT_TRUE(cad_mark_words({static_cast<cad_status>(9), {}, 0}).isEmpty());
}

}  // namespace
}  // namespace tedit::desktop
