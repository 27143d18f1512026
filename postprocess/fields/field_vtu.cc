// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/fields/field_vtu.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <numbers>
#include <ostream>

#include "cases/program/output_file.h"
#include "mesh/cells/cell_kind.h"
#include "postprocess/tables/packing.h"

namespace tiprub::postprocess {

namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

/// An array in VTK's inline compressed format: the number of blocks, their length in bytes, that of a last one which
/// is shorter, and the length of each when compressed; then the blocks. Either is in base 64 by itself. There is one
/// block.
template <class Value>
std::string encoded(const std::vector<Value>& values) {
  const std::string block(reinterpret_cast<const char*>(values.data()), sizeof(Value) * values.size());
  const std::string packed = deflated(block, Packing::fast);
  const std::array<std::uint64_t, 4> head = {1, block.size(), 0, packed.size()};
  return base64({reinterpret_cast<const char*>(head.data()), sizeof head}) + base64(packed);
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
  for (const auto& [name, value] : numbers)
    out << "<DataArray Name=\"" << name << "\" type=\"Float64\" NumberOfTuples=\"1\" format=\"ascii\">" << value
        << "</DataArray>\n";
  out << "</FieldData>\n";
}

void write_fields(std::ostream& out, const char* element, const std::vector<VtuArray>& arrays) {
  out << "<" << element << ">\n";
  for (const VtuArray& array : arrays)
    write_array(out, array.name, "Float32", static_cast<int>(array.values.rows()), single(array.values));
  out << "</" << element << ">\n";
}

void write_document(std::ostream& out, const VtuMesh& mesh, const std::vector<VtuArray>& arrays,
                    const std::vector<VtuNumber>& numbers, const std::vector<VtuArray>& of_cells) {
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
  write_numbers(out, numbers);
  out << "<Piece NumberOfPoints=\"" << mesh.points.cols() << "\" NumberOfCells=\"" << mesh.cells.cols()
      << "\">\n<Points>\n";
  write_array(out, "Points", "Float32", 3, single(mesh.points));
  out << "</Points>\n";
  write_cells(out, mesh.cells);
  write_fields(out, "PointData", arrays);
  if (!of_cells.empty()) write_fields(out, "CellData", of_cells);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string name_of(const ModeField& mode) {
  return "nd" + std::to_string(mode.wave.nodal_diameter) + "_family" + std::to_string(mode.family + 1);
}

/// All sectors in one mesh, which holds the nodes of the cut faces twice.
VtuMesh wheel_mesh(const SectorFields& sector) {
  const Eigen::Index nodes = sector.nodes.cols(), cells = sector.cells.cols();
  VtuMesh mesh{Eigen::Matrix3Xd(3, nodes * sector.sector_count),
               Eigen::MatrixXi(sector.cells.rows(), cells * sector.sector_count)};
  for (int j = 0; j < sector.sector_count; ++j) {
    mesh.points.middleCols(j * nodes, nodes) = nodes_of_sector(sector, j);
    mesh.cells.middleCols(j * cells, cells) =
        (sector.cells.array() < 0).select(-1, sector.cells.array() + static_cast<int>(j * nodes));
  }
  return mesh;
}

/// Columns of all sectors, one sector after the other.
template <class Matrix>
Eigen::MatrixXd joined(const std::vector<Matrix>& by_sector) {
  const Eigen::Index nodes = by_sector.front().cols();
  Eigen::MatrixXd all(by_sector.front().rows(), nodes * static_cast<Eigen::Index>(by_sector.size()));
  for (std::size_t j = 0; j < by_sector.size(); ++j)
    all.middleCols(static_cast<Eigen::Index>(j) * nodes, nodes) = by_sector[j];
  return all;
}

/// 0 none, 1 clamped, 2 contact, 3 lower cut face, 4 upper one.
Eigen::MatrixXd node_set_numbers(const SectorFields& sector) {
  Eigen::MatrixXd numbers = Eigen::MatrixXd::Zero(1, sector.nodes.cols());
  constexpr std::array<std::pair<const char*, int>, 4> sets = {
      {{"cyclic_low", 3}, {"cyclic_high", 4}, {"clamped", 1}, {"contact", 2}}};
  for (const auto& [name, number] : sets)
    for (const int node : sector.node_set(name)) numbers(0, node) = number;
  return numbers;
}

std::vector<VtuArray> instant_arrays(const WheelField& vibration, const WheelField& spin) {
  std::vector<Eigen::MatrixXd> mises_vibration, mises_spin, mises;
  for (std::size_t j = 0; j < vibration.stress.size(); ++j) {
    mises_vibration.emplace_back(von_mises(vibration.stress[j]).transpose());
    mises_spin.emplace_back(von_mises(spin.stress[j]).transpose());
    mises.emplace_back(von_mises(vibration.stress[j] + spin.stress[j]).transpose());
  }
  return {{"displacement_vibration", joined(vibration.displacement)},
          {"displacement_spin", joined(spin.displacement)},
          {"stress_vibration", joined(vibration.stress)},
          {"stress_spin", joined(spin.stress)},
          {"von_mises_vibration", joined(mises_vibration)},
          {"von_mises_spin", joined(mises_spin)},
          {"von_mises", joined(mises)}};
}

/// The wave a quarter of a period later. At phase p the mode is cos(p) times the first and sin(p) times this one.
WaveField quarter_later(WaveField wave) {
  wave.displacement *= std::complex<double>(0, 1);
  return wave;
}

void write_modes(const FieldStudy& fields, const std::filesystem::path& folder) {
  std::vector<VtuNumber> numbers = {{"speed", fields.speed}};
  std::vector<VtuArray> sector_arrays = {{"node_set", node_set_numbers(fields.sector)}}, wheel_arrays;
  for (const ModeField& mode : fields.modes.drawn) {
    sector_arrays.push_back({name_of(mode) + "_cosine", mode.wave.displacement.real()});
    sector_arrays.push_back({name_of(mode) + "_sine", mode.wave.displacement.imag()});
    const int sectors = fields.sector.sector_count;
    wheel_arrays.push_back({name_of(mode), joined(on_wheel({mode.wave}, sectors).displacement)});
    wheel_arrays.push_back(
        {name_of(mode) + "_quarter", joined(on_wheel({quarter_later(mode.wave)}, sectors).displacement)});
    numbers.push_back({name_of(mode) + "_frequency", mode.frequency});
  }
  std::vector<VtuArray> of_cells;
  if (fields.mesh_error_of_frequencies.size() > 0)
    of_cells = {{"mesh_error_of_frequencies", fields.mesh_error_of_frequencies.transpose()},
                {"mesh_error_of_compliances", fields.mesh_error_of_compliances.transpose()}};
  write_vtu({fields.sector.nodes, fields.sector.cells}, sector_arrays, numbers, folder / "modes_sector.vtu",
            of_cells);
  write_vtu(wheel_mesh(fields.sector), wheel_arrays, numbers, folder / "modes_wheel.vtu");
}

/// A collection of files over time [s] for ParaView; their paths are relative to it.
void write_pvd(const std::vector<std::pair<double, std::string>>& frames, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
           "<Collection>\n";
    for (const auto& [time, file] : frames) out << "<DataSet timestep=\"" << time << "\" file=\"" << file << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
  });
}

/// One sector over a revolution of the rotor, without stress.
void write_motion(const FieldStudy& fields, const MovingWheel& moving, int sector,
                  const std::filesystem::path& folder) {
  constexpr int frames = 24;
  const std::string name = "motion_sector";
  std::filesystem::create_directories(folder / name);
  const VtuMesh mesh{nodes_of_sector(fields.sector, sector), fields.sector.cells};
  const Eigen::Matrix3d to_its_place(
      Eigen::AngleAxisd(2 * std::numbers::pi * sector / fields.sector.sector_count, Eigen::Vector3d::UnitZ()));
  std::vector<std::pair<double, std::string>> written;  // [s] of each file
  for (int frame = 0; frame < frames; ++frame) {
    const double angle = 2 * std::numbers::pi * frame / frames;
    std::vector<WaveField> waves = moving.waves;
    for (std::size_t i = 0; i < waves.size(); ++i)
      waves[i].displacement *= std::polar(1.0, moving.motion.waves[i].engine_order * angle);
    const Eigen::Matrix3Xd moved = to_its_place * on_sector(waves, sector, fields.sector.sector_count).displacement;
    const std::string file = name + "/" + (frame < 10 ? "0" : "") + std::to_string(frame) + ".vtu";
    write_vtu(mesh, {{"displacement", moved}}, {{"speed", moving.speed}, {"rotor_angle", angle}}, folder / file);
    written.emplace_back(angle / moving.speed, file);
  }
  write_pvd(written, folder / (name + ".pvd"));
}

}  // namespace

void write_vtu(const VtuMesh& mesh, const std::vector<VtuArray>& arrays, const std::vector<VtuNumber>& numbers,
               const std::filesystem::path& path, const std::vector<VtuArray>& of_cells) {
  write_file(path, [&](std::ostream& out) { write_document(out, mesh, arrays, numbers, of_cells); });
}

const MovingWheel* moving_at_instant(const FieldStudy& fields) {
  const auto found = std::ranges::find(fields.moving, fields.speed, &MovingWheel::speed);
  return fields.has_instant && found != fields.moving.end() && !found->waves.empty() ? &*found : nullptr;
}

void write_vtu_files(const FieldStudy& fields, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_modes(fields, folder);
  if (!fields.has_instant) return;
  const WheelField &vibration = fields.vibration, &spin = fields.spin;
  const std::vector<VtuNumber> numbers = {
      {"speed", fields.speed}, {"rotor_angle", fields.angle}, {"contact_force", fields.force}};
  write_vtu(wheel_mesh(fields.sector), instant_arrays(vibration, spin), numbers, folder / "contact_wheel.vtu");
  int worst = 0;
  double largest = 0;
  for (int k = 0; k < fields.sector.sector_count; ++k) {
    const double here = von_mises(vibration.stress[static_cast<std::size_t>(k)]).maxCoeff();
    if (here > largest) worst = k;
    largest = std::max(largest, here);
  }
  const auto j = static_cast<std::size_t>(worst);
  std::vector<VtuArray> arrays = instant_arrays({{vibration.displacement[j]}, {vibration.stress[j]}},
                                                {{spin.displacement[j]}, {spin.stress[j]}});
  arrays.push_back({"node_set", node_set_numbers(fields.sector)});
  write_vtu({nodes_of_sector(fields.sector, worst), fields.sector.cells}, arrays, numbers,
            folder / "contact_sector.vtu");
  if (const MovingWheel* const moving = moving_at_instant(fields)) write_motion(fields, *moving, worst, folder);
}

}  // namespace tiprub::postprocess
