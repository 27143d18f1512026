// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/vtu_file.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <ostream>

#include "cases/program/output_file.h"
#include "mesh/cells/cell_kind.h"
#include "postprocess/tables/packing.h"

namespace tiprub {

namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

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
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  for (Eigen::Index cell = 0; cell < cells.cols(); ++cell) {
    const auto nodes = nodes_of(cells, cell);
    connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(static_cast<std::uint8_t>(cell_kind(static_cast<int>(nodes.size())).vtk_type));
  }
  out << "<Cells>\n";
  write_array(out, "connectivity", "Int32", 1, connectivity);
  write_array(out, "offsets", "Int32", 1, offsets);
  write_array(out, "types", "UInt8", 1, types);
  out << "</Cells>\n";
}

void write_numbers(std::ostream& out, const std::vector<VtuNumber>& numbers) {
  out << "<FieldData>\n";
  for (const VtuNumber& number : numbers)
    out << "<DataArray Name=\"" << number.name << "\" type=\"Float64\" NumberOfTuples=\"1\" format=\"ascii\">"
        << number.value << "</DataArray>\n";
  out << "</FieldData>\n";
}

void write_document(std::ostream& out, const VtuMesh& mesh, const std::vector<VtuArray>& arrays,
                    const std::vector<VtuNumber>& numbers) {
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  write_numbers(out, numbers);
  out << "<Piece NumberOfPoints=\"" << mesh.points.cols() << "\" NumberOfCells=\"" << mesh.cells.cols()
      << "\">\n<Points>\n";
  write_array(out, "Points", "Float32", 3, single(mesh.points));
  out << "</Points>\n";
  write_cells(out, mesh.cells);
  out << "<PointData>\n";
  for (const VtuArray& array : arrays)
    write_array(out, array.name, "Float32", static_cast<int>(array.values.rows()), single(array.values));
  out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

void write_vtu(const VtuMesh& mesh, const std::vector<VtuArray>& arrays, const std::vector<VtuNumber>& numbers,
               const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& out) { write_document(out, mesh, arrays, numbers); });
}

void write_pvd(const std::vector<VtuFrame>& frames, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
           "<Collection>\n";
    for (const VtuFrame& frame : frames)
      out << "<DataSet timestep=\"" << frame.time << "\" file=\"" << frame.file << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
  });
}

}  // namespace tiprub
