// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/med/med_file.hpp"

#include <cstring>
#include <optional>
#include <utility>

namespace tedit::med {

namespace {

/// No such file can be there: libmed looks before it takes the memory.
constexpr auto no_file = "/dev/null/part.med";

constexpr auto write_again = "Write or copy the file again";

template <class Number>
std::optional<Number> number_at(std::span<const char> bytes, std::size_t at) {
  Number value{};
  if (at + sizeof(value) > bytes.size())
    return std::nullopt;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

/// Where the file ends by its own word (HDF5 file format, superblock), for numbers of 8 bytes.
std::optional<std::uint64_t> end_of_file(std::span<const char> bytes) {
  const auto version = number_at<std::uint8_t>(bytes, 8);
  if (!version)
    return std::nullopt;
  const bool old = *version < 2;
  const auto width = number_at<std::uint8_t>(bytes, old ? 13 : 9);
  if (width != std::uint8_t{8})
    return std::nullopt;
  return number_at<std::uint64_t>(bytes, *version == 0 ? 40 : *version == 1 ? 44 : 28);
}

void check_size(std::span<const char> bytes) {
  const auto end = end_of_file(bytes);
  if (!end)
    refuse(ec::bad_input, "the head of the HDF5 file is cut off or damaged", write_again);
  if (*end > bytes.size())
    refuse(ec::bad_input,
           "the file has " + std::to_string(bytes.size()) + " bytes of the " +
             std::to_string(*end) + " that its head says",
           "It is cut off: write or copy it again");
}

void check_is_med(med_idt id) {
  if (H5Lexists(id, "INFOS_GENERALES", H5P_DEFAULT) <= 0)
    refuse(ec::unsupported_format, "this is an HDF5 file, but no MED: it has no INFOS_GENERALES",
           "Export the mesh as MED, .unv or .inp");
  med_int major = 0;
  med_int minor = 0;
  med_int release = 0;
  if (MEDfileNumVersionRd(id, &major, &minor, &release) < 0)
    refuse_damaged("the version of MED");
  if (major < 3 || major > MED_NUM_MAJEUR)
    refuse(ec::unsupported_format,
           "the file is MED " + std::to_string(major) + "." + std::to_string(minor) +
             "; read are 3 and 4",
           "Open it in Salome and export it as MED 4");
}

}  // namespace

void refuse(ec code, std::string message, std::string remedy) {
  throw refusal{{code, std::move(message), std::move(remedy), {}}};
}

void refuse_damaged(const std::string& what) {
  refuse(ec::bad_input, "libmed cannot read " + what + ": the file is damaged", write_again);
}

med_file::med_file(std::span<const char> bytes) {
  check_size(bytes);
  memory_.app_image_ptr = const_cast<char*>(bytes.data());
  memory_.app_image_size = bytes.size();
  id_ = MEDmemFileOpen(no_file, &memory_, MED_FALSE, MED_ACC_RDONLY);
  if (id_ < 0)
    refuse(ec::bad_input, "HDF5 cannot open the file: it is damaged, or no MED", write_again);
  check_is_med(id_);
}

med_file::med_file() : id_(MEDmemFileOpen(no_file, &memory_, MED_FALSE, MED_ACC_CREAT)) {
  if (id_ < 0)
    refuse(ec::internal, "libmed cannot make a file in memory", "Try again");
}

med_file::~med_file() {
  if (id_ >= 0)
    MEDfileClose(id_);
}

std::vector<char> med_file::close() {
  const auto id = std::exchange(id_, -1);
  if (MEDfileClose(id) < 0 || !memory_.app_image_ptr)
    refuse(ec::internal, "libmed cannot finish the file", "Try again");
  const auto* first = static_cast<const char*>(memory_.app_image_ptr);
  return {first, first + memory_.app_image_size};
}

std::string text_in(const char* field, std::size_t most) {
  std::string text(field, strnlen(field, most));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace tedit::med
