// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// Runs the fuzz target over one file; its name goes out first, so that a crash names it.
void replay(const std::filesystem::path& file) {
  std::printf("%s\n", file.c_str());
  std::fflush(stdout);
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

/// fuzz_replay <folder or file>...: every file through the fuzz target, without libFuzzer.
int main(int argc, char** argv) {
  std::size_t files = 0;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::filesystem::path place = argv[i];
      if (!std::filesystem::is_directory(place)) {
        replay(place);
        ++files;
        continue;
      }
      for (const auto& entry : std::filesystem::recursive_directory_iterator(place))
        if (entry.is_regular_file()) {
          replay(entry.path());
          ++files;
        }
    }
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "fuzz_replay: %s\n", failure.what());
    return 1;
  }
  std::printf("%zu files\n", files);
  return files > 0 ? 0 : 2;
}
