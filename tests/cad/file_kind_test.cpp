// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/file_kind.hpp"

#include <gmock/gmock.h>

#include "tests/support/scratch.hpp"

namespace tedit::cad {
namespace {

TEST(FileKind, IsToldByTheBytesAndNotByTheName) {
  const std::filesystem::path parts = TEDIT_TEST_DATA "/cad";
  const test::scratch_folder folder;
  std::filesystem::copy(parts / "box.igs", folder.path() / "box.step");

  EXPECT_EQ(test::value(kind_of(parts / "box.step")), file_kind::step);
  EXPECT_EQ(test::value(kind_of(parts / "box.brep")), file_kind::brep);
  EXPECT_EQ(test::value(kind_of(folder.path() / "box.step")), file_kind::iges);
}

TEST(FilesReferredTo, AreNamedOnce) {
  EXPECT_THAT(files_referred_to("#1=DOCUMENT_FILE('a.stp','',$,#2,'',$);\n"
                                "#2=APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT ( 'b.stp' , #3);\n"
                                "#3=DOCUMENT_FILE('a.stp','',$,#2,'',$);#4=DOCUMENT_FILE();"),
              ::testing::ElementsAre("a.stp", "b.stp"));
  EXPECT_TRUE(files_referred_to("#1=PRODUCT('p');").empty());
}

}  // namespace
}  // namespace tedit::cad
