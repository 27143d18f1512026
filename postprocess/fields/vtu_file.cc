// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/vtu_file.h"

#include <bit>
#include <cstdint>
#include <ostream>

#include "cases/program/output_file.h"
#include "postprocess/tables/base64.h"

namespace tiprub {

namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

constexpr int serendipity_nodes = 20;
constexpr std::uint8_t quadratic_hexahedron = 25, triquadratic_hexahedron = 29;

/// One array as VTK's inline binary: its length in bytes, then itself, together in base 64.
template <class Value>
std::string encoded(const std::vector<Value>& values) {
  const std::uint64_t length = sizeof(Value) * values.size();
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes.append(reinterpret_cast<const char*>(values.data()), length);
  return base64(bytes);
}

template <class Value>
void write_array(std::ostream& out, const std::string& name, const char* type, int components,
                 const std::vector<Value>& values) {
  out << "<DataArray Name=\"" << name << "\" type=\"" << type << "\" NumberOfComponents=\"" << components
      << "\" format=\"binary\">" << encoded(values) << "</DataArray>\n";
}

std::vector<float> single(const Eigen::MatrixXd& values) {
  const Eigen::MatrixXf converted = values.cast<float>();
  return {converted.data(), converted.data() + converted.size()};
}

void write_cells(std::ostream& out, const Eigen::MatrixXi& cells) {
  const auto count = static_cast<std::size_t>(cells.cols());
  std::vector<std::int32_t> offsets(count);
  for (std::size_t cell = 0; cell < count; ++cell)
    offsets[cell] = static_cast<std::int32_t>((cell + 1) * static_cast<std::size_t>(cells.rows()));
  out << "<Cells>\n";
  write_array(out, "connectivity", "Int32", 1, std::vector<std::int32_t>(cells.data(), cells.data() + cells.size()));
  write_array(out, "offsets", "Int32", 1, offsets);
  write_array(out, "types", "UInt8", 1,
              std::vector<std::uint8_t>(
                  count, cells.rows() == serendipity_nodes ? quadratic_hexahedron : triquadratic_hexahedron));
  out << "</Cells>\n";
}

void write_document(std::ostream& out, const VtuMesh& mesh, const std::vector<VtuArray>& arrays) {
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
      << mesh.points.cols() << "\" NumberOfCells=\"" << mesh.cells.cols() << "\">\n<Points>\n";
  write_array(out, "Points", "Float32", 3, single(mesh.points));
  out << "</Points>\n";
  write_cells(out, mesh.cells);
  out << "<PointData>\n";
  for (const VtuArray& array : arrays)
    write_array(out, array.name, "Float32", static_cast<int>(array.values.rows()), single(array.values));
  out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

void write_vtu(const VtuMesh& mesh, const std::vector<VtuArray>& arrays, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& out) { write_document(out, mesh, arrays); });
}

}  // namespace tiprub
