// SPDX-License-Identifier: AGPL-3.0-or-later
// The texts of CAD files without their readers: sound ones have no fault, and none is too damaged
// to be looked at.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <gmock/gmock.h>

#include "cad/reader/text_faults.hpp"

namespace tedit::cad {
namespace {

using look = std::optional<text_fault> (*)(std::string_view);

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::filesystem::path parts = TEDIT_TEST_DATA "/cad";

TEST(CadTexts, ThatAreReadHaveNoFault) {
  for (const auto* name : {"box.step", "as1_assembly.stp", "inch_block.stp", "l_bracket.stp"})
    EXPECT_FALSE(fault_of_step(bytes_of(parts / name))) << name;
  EXPECT_FALSE(fault_of_iges(bytes_of(parts / "box.igs")));
  for (const auto* name :
       {"box.brep", "open_box.brep", "narrow_face.brep", "overlapping_boxes.brep"})
    EXPECT_FALSE(fault_of_brep(bytes_of(parts / name))) << name;
}

/// Faces of a shell may list one loop again and again, and a loop one edge.
TEST(CadTexts, ThatListTheSameAgainAndAgainAreLookedAtInBounds) {
  std::string all = "(";
  for (int i = 0; i < 2000; ++i)
    all += (i > 0 ? ",#" : "#") + std::string("NEXT");
  const auto list = [&](const std::string& id) {
    auto text = all + ")";
    for (auto at = text.find("NEXT"); at != std::string::npos; at = text.find("NEXT"))
      text.replace(at, 4, id);
    return text;
  };
  const std::string text = "ISO-10303-21;HEADER;ENDSEC;DATA;#1=CLOSED_SHELL(''," + list("2") +
                           ");#2=ADVANCED_FACE(''," + list("3") + ",#9,.T.);#3=FACE_BOUND(''," +
                           list("4") + ",.T.);#4=EDGE_LOOP(''," + list("5") +
                           ");#5=ORIENTED_EDGE('',*,*,#6,.T.);#6=EDGE_CURVE('',#7,#7,#10,.T.);"
                           "#7=VERTEX_POINT('',#8);#8=CARTESIAN_POINT('',(0.,0.,0.));"
                           "#9=PLANE('',#8);#10=LINE('',#8,#8);"
                           "#11=SHAPE_REPRESENTATION('',(#1),#8);ENDSEC;END-ISO-10303-21;";

  EXPECT_FALSE(fault_of_step(text));
}

/// Other letters, pieces that are missing or there twice, and cuts.
std::string damaged(const std::string& whole, std::mt19937& random) {
  auto text = whole;
  for (auto left = 1 + random() % 4; left > 0; --left) {
    const auto at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text[at] = "#'();,*$=0\n"[random() % 11];
        break;
      case 2:
        text.erase(at, 1 + random() % 40);
        break;
      default:
        text.insert(at, text.substr(random() % text.size(), random() % 60));
    }
  }
  return text;
}

TEST(CadTexts, ThatAreDamagedHaveAFaultWithinThem) {
  const std::pair<const char*, look> kinds[] = {
    {"box.step", fault_of_step}, {"box.igs", fault_of_iges}, {"box.brep", fault_of_brep}};
  for (const auto& [name, fault_of] : kinds) {
    const auto whole = bytes_of(parts / name);
    std::mt19937 random(3);
    int told = 0;
    constexpr int tries = 500;
    for (int i = 0; i < tries; ++i) {
      const auto text = damaged(whole, random);
      const auto fault = fault_of(text);
      told += fault.has_value();
      if (fault) {
        EXPECT_LE(fault->at, text.size()) << name << " " << i;
        EXPECT_NE(fault->cause, "") << name << " " << i;
        EXPECT_NE(fault->remedy, "") << name << " " << i;
      }
    }
    EXPECT_GT(told, tries / 2) << name;
  }
}

}  // namespace
}  // namespace tedit::cad
