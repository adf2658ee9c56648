// SPDX-License-Identifier: AGPL-3.0-or-later
// Programs that die, hang or take too much, and files that are none: what is said, and what is
// left.
#include "tests/cad/import_program.hpp"

namespace tedit::test {
namespace {

/// A folder of programs of which the reader is a script.
std::string with_reader(const std::string& script) {
  std::filesystem::remove(scratch("tedit-cad-reader"));  // Maybe a link of a run before.
  const auto reader = write_scratch("tedit-cad-reader", "#!/bin/sh\n" + script);
  std::filesystem::permissions(reader, std::filesystem::perms::owner_all);
  const auto mesher = scratch("tedit-cad-mesher");
  std::filesystem::copy_file(reader, mesher, std::filesystem::copy_options::overwrite_existing);
  return reader.parent_path().string();
}

struct libexec {
  explicit libexec(const std::string& folder) { setenv("TEDIT_LIBEXEC", folder.c_str(), 1); }
  ~libexec() { unsetenv("TEDIT_LIBEXEC"); }
};

constexpr auto transferring = R"(printf 'S\t0.3\ttransferring the model\n')";

TEST(Reader, ThatDiesSaysWhatItWasDoing) {
  const libexec programs(with_reader(std::string(transferring) + "\nkill -SEGV $$\n"));
  const auto out = scratch("part.msh");
  std::filesystem::remove(out);

  const auto brep = refusal_of(cad_parts + "box.brep -o " + out.string(), 65);
  const auto step = refusal_of(cad_parts + "box.step -o " + out.string(), 65);

  EXPECT_EQ(brep["message"], "the reader died while transferring the model (signal 11)");
  EXPECT_EQ(step["message"],
            "the reader died while transferring the model (signal 11), and once more without "
            "annotations");
  EXPECT_THAT(step["remedy"].get<std::string>(), HasSubstr("AP203 or AP214"));
  EXPECT_EQ(step["where"], cad_parts + "box.step");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Reader, ThatHangsIsEndedAtItsTime) {
  const libexec programs(with_reader(std::string(transferring) + "\nexec sleep 60\n"));

  const auto said = refusal_of(cad_parts + "box.step --time-limit 1", 1);

  EXPECT_EQ(said["code"], "timeout");
  EXPECT_EQ(said["message"], "the reader took longer than 1 s while transferring the model");
  EXPECT_THAT(said["remedy"].get<std::string>(), HasSubstr("--time-limit"));
}

TEST(Reader, ThatClosesItsLineAndHangsIsEndedAtItsTime) {
  const libexec programs(with_reader(std::string(transferring) + "\nexec sleep 60 >&-\n"));

  EXPECT_EQ(refusal_of(cad_parts + "box.step --time-limit 1", 1)["message"],
            "the reader took longer than 1 s while transferring the model");
}

TEST(Reader, ThatExitsWithoutAWordIsNoSuccess) {
  const libexec programs(with_reader("exit 3\n"));

  EXPECT_EQ(refusal_of(cad_parts + "box.brep", 65)["message"],
            "the reader died before it began (exit status 3)");
}

TEST(Reader, ThatClaimsToBeDoneAndWroteNothingIsNotBelieved) {
  const libexec programs(with_reader("exit 0\n"));

  const auto said = refusal_of(cad_parts + "box.brep", 1);

  EXPECT_EQ(said["code"], "internal");
  EXPECT_THAT(said["message"].get<std::string>(), HasSubstr("part.json"));
}

TEST(Reader, ThatIsNotThereIsNamedWithThePackages) {
  const libexec programs(scratch("nothing").string());

  const auto said = refusal_of(cad_parts + "box.step", 69);

  EXPECT_THAT(said["message"].get<std::string>(), HasSubstr("tedit-cad-reader"));
  EXPECT_THAT(said["remedy"].get<std::string>(), HasSubstr("libgmsh-dev"));
}

TEST(Mesher, ThatNeedsMoreMemoryThanItMayTakeSaysSo) {
  TEDIT_NEEDS_CAD();
#ifdef TEDIT_SANITIZED
  GTEST_SKIP() << "sanitizers reserve more addresses than any limit";
#endif
  const auto said = refusal_of(cad_parts + "as1_assembly.stp --size medium --memory-mb 256", 1);

  EXPECT_EQ(said["code"], "out_of_memory");
  EXPECT_EQ(said["message"], "the mesher needs more memory than it may take");
  EXPECT_THAT(said["remedy"].get<std::string>(), HasSubstr("--memory-mb"));
}

TEST(Mesher, ThatTakesTooLongSaysWhatItWasDoing) {
  TEDIT_NEEDS_CAD();
  const auto said = refusal_of(cad_parts + "as1_assembly.stp --size fine --time-limit 2", 1);

  EXPECT_EQ(said["code"], "timeout");
  EXPECT_THAT(said["message"].get<std::string>(), HasSubstr(" took longer than 2 s while "));
}

TEST(Mesher, ThatDiesSaysAtWhichSurface) {
  TEDIT_NEEDS_CAD();
  const auto folder = with_reader(
    "echo 'Info    : [ 10%] Meshing surface 1 (Plane, Frontal-Delaunay)' >> $1/messages.txt\n"
    "printf 'S\\t0.2\\tmeshing the surfaces\\n'\n"
    "kill -ABRT $$\n");
  std::filesystem::remove(folder + "/tedit-cad-reader");
  std::filesystem::create_symlink(TEDIT_BIN "/tedit-cad-reader", folder + "/tedit-cad-reader");
  const libexec programs(folder);

  const auto said = refusal_of(cad_parts + "box.step", 1);

  EXPECT_EQ(said["code"], "mesher_failed");
  EXPECT_EQ(said["message"],
            "the mesher died while meshing the surfaces (signal 6), at surface 1 (left wall)");
  EXPECT_THAT(said["remedy"].get<std::string>(), HasSubstr("simplify that face"));
}

struct refused_file {
  const char* name;
  std::string content;
  int status;
  const char* code;
  const char* message;
};

TEST(Import, RefusesWhatIsNoPartWithTheReason) {
  TEDIT_NEEDS_CAD();
  const auto step = text_of_file(cad_parts + "box.step");
  const auto head = step.substr(0, step.find("DATA;"));
  const std::vector<refused_file> files{
    {"empty.step", "", 65, "bad_input", "the file is empty"},
    {"blank.step", " \n\n ", 65, "bad_input", "the file is empty"},
    {"picture.step", "\x89PNG\r\n", 65, "unsupported_format",
     "this is no STEP, IGES or BREP file: it looks like a picture"},
    {"mesh.step", "$MeshFormat\n4.1 0 8\n", 65, "unsupported_format",
     "this is no STEP, IGES or BREP file: it looks like a Gmsh mesh, which the other commands take "
     "as it is"},
    {"surface.stp", "solid box\n facet normal 0 0 1\n", 65, "bad_input",
     "the STL file ends within a facet"},
    {"words.stp", "My part.", 65, "unsupported_format",
     "this is no STEP, IGES or BREP file: it looks like something else"},
    {"no_data.step", head + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n", 65, "bad_input", ""},
    {"damaged.brep", "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations",
     65, "bad_input", ""}};
  for (const auto& one : files) {
    const auto said = refusal_of(write_scratch(one.name, one.content).string(), one.status);
    EXPECT_EQ(said["code"], one.code) << one.name << said;
    if (*one.message != '\0') {
      EXPECT_EQ(said["message"], one.message) << one.name;
    }
    EXPECT_NE(said["message"], "") << one.name;
    EXPECT_NE(said["remedy"], "") << one.name;
  }
}

TEST(Import, OfAFileThatRefersToOthersNamesThem) {
  TEDIT_NEEDS_CAD();
  const auto said = refusal_of(cad_parts + "elsewhere.step", 65);

  EXPECT_EQ(said["message"],
            "the file has no solid of its own: it refers to 2 other files (upper_arm.step, "
            "lower_arm.step)");
  EXPECT_THAT(said["remedy"].get<std::string>(), HasSubstr("one STEP file"));
}

TEST(Import, OfFacesThatCloseNoVolumeSaysSo) {
  TEDIT_NEEDS_CAD();
  const auto said = refusal_of(cad_parts + "open_box.brep", 65);

  EXPECT_EQ(said["message"],
            "there is no solid in the file: it holds surfaces that close no volume");
}

TEST(Import, OfAFileThatIsNotThereSaysSo) {
  const auto said = refusal_of(cad_parts + "nothing.step", 65);

  EXPECT_EQ(said["code"], "io_error");
  EXPECT_THAT(said["message"].get<std::string>(), HasSubstr("there is no such file"));
}

TEST(Import, RefusesASuffixThatNoFormatHasBeforeTheWork) {
  EXPECT_EQ(refusal_of(cad_parts + "box.step -o part.step", 2)["message"],
            "there is no file format \"step\" to write");
}

TEST(Import, LeavesNoFolderBehindAndTakesAwayThatOfOneThatWasKilled) {
  TEDIT_NEEDS_CAD();
  const auto folder = scratch("tmp");
  // No process has such a number: the kernel's largest is 4194304.
  std::filesystem::create_directories(folder / "tedit-import-4194305-abcdef" / "inner");
  setenv("TMPDIR", folder.c_str(), 1);
  run("import " + cad_parts + "box.step");
  run("import " + cad_parts + "elsewhere.step");
  unsetenv("TMPDIR");

  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace tedit::test
