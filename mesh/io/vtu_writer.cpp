// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/vtu_writer.hpp"

#include <cstdint>
#include <ostream>

#include "mesh/io/file.hpp"

namespace tedit {

namespace {

/// Collects the arrays of the appended section and their offsets.
class appended_data {
public:
  /// The opening attributes of an array whose `bytes` come later.
  std::string add(const char* type, const std::string& name, int components,
                  std::span<const std::byte> bytes) {
    blocks_.push_back(bytes);
    const auto offset = next_;
    next_ += sizeof(std::uint64_t) + bytes.size();
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
           "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
  }

  void write(std::ostream& out) const {
    out << "<AppendedData encoding=\"raw\">\n_";
    for (const auto& block : blocks_) {
      const std::uint64_t size = block.size();
      out.write(reinterpret_cast<const char*>(&size), sizeof(size));
      out.write(reinterpret_cast<const char*>(block.data()),
                static_cast<std::streamsize>(block.size()));
    }
    out << "\n</AppendedData>\n";
  }

private:
  std::vector<std::span<const std::byte>> blocks_;
  std::uint64_t next_ = 0;
};

std::uint8_t cell_type(int nodes) {
  return nodes == 3 ? 5 : nodes == 4 ? 10 : 24;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string text_array(const std::string& name, const std::string& text) {
  std::string result = "<DataArray type=\"String\" Name=\"" + escaped(name) +
                       "\" NumberOfTuples=\"1\" format=\"ascii\">\n";
  for (const unsigned char c : text)
    result += std::to_string(c) + " ";
  return result + "0\n</DataArray>\n";
}

std::string byte_array(const std::string& name, const std::vector<std::string>& texts) {
  std::string bytes;
  std::size_t count = 0;
  for (const auto& text : texts) {
    for (const unsigned char c : text)
      bytes += std::to_string(c) + " ";
    bytes += "0\n";
    count += text.size() + 1;
  }
  return "<DataArray type=\"UInt8\" Name=\"" + escaped(name) +
         "\" NumberOfComponents=\"1\" NumberOfTuples=\"" + std::to_string(count) +
         "\" format=\"ascii\">\n" + bytes + "</DataArray>\n";
}

std::string field_data(const vtu_grid& grid, appended_data& data) {
  std::string result;
  for (const auto& [name, text] : grid.notes)
    result += text_array(name, text);
  for (const auto& [name, texts] : grid.texts)
    result += byte_array(name, texts);
  for (const auto& one : grid.numbers) {
    auto array = data.add("Int64", escaped(one.name), one.components, std::as_bytes(one.values));
    const auto tuples = one.values.size() / static_cast<std::size_t>(one.components);
    array.insert(array.find(" format="), " NumberOfTuples=\"" + std::to_string(tuples) + "\"");
    result += array;
  }
  return result.empty() ? result : "<FieldData>\n" + result + "</FieldData>\n";
}

}  // namespace

expected<void> write_vtu(const file_target& to, const vtu_grid& grid) {
  const std::size_t cells = grid.cells.size() / static_cast<std::size_t>(grid.nodes_per_cell);
  std::vector<std::int64_t> connectivity(grid.cells.begin(), grid.cells.end());
  std::vector<std::int64_t> offsets(cells);
  for (std::size_t c = 0; c < cells; ++c)
    offsets[c] = static_cast<std::int64_t>(c + 1) * grid.nodes_per_cell;
  const std::vector<std::uint8_t> types(cells, cell_type(grid.nodes_per_cell));

  appended_data data;
  std::string head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  head += field_data(grid, data);
  head += "<Piece NumberOfPoints=\"" + std::to_string(grid.points.size()) + "\" NumberOfCells=\"" +
          std::to_string(cells) + "\">\n<Points>\n";
  head += data.add("Float64", "Points", 3, std::as_bytes(grid.points));
  head += "</Points>\n<Cells>\n";
  head += data.add("Int64", "connectivity", 1, std::as_bytes(std::span(connectivity)));
  head += data.add("Int64", "offsets", 1, std::as_bytes(std::span(offsets)));
  head += data.add("UInt8", "types", 1, std::as_bytes(std::span(types)));
  head += "</Cells>\n<PointData>\n";
  for (const auto& array : grid.point_data)
    head += data.add("Float64", escaped(array.name), array.components, std::as_bytes(array.values));
  head += "</PointData>\n<CellData>\n";
  for (const auto& array : grid.cell_data)
    head += data.add("Float64", escaped(array.name), array.components, std::as_bytes(array.values));
  head += "</CellData>\n</Piece>\n</UnstructuredGrid>\n";
  return to.write([&](std::ostream& out) {
    out << head;
    data.write(out);
    out << "</VTKFile>\n";
  });
}

}  // namespace tedit
