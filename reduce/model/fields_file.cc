// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/fields_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "cases/program/digest.h"
#include "cases/program/machine.h"
#include "mesh/cells/cell_kind.h"
#include "mesh/cells/free_faces.h"

namespace tiprub {

namespace {

constexpr const char* fields_schema = "tiprub-fields";
constexpr int fields_schema_version = 2;
constexpr Eigen::Index slices_at_once = 64;  // columns of a product
constexpr Eigen::Index rows_at_once = 1024;  // of a product: its numbers fit into a processor's second cache
constexpr double widest_mismatch = 0.01;     // of the radius, between partners: the most that reduce allows
constexpr const char* cell_errors_group = "/mesh_error";
constexpr const char* required_sets[] = {"clamped", "contact", "cyclic_low", "cyclic_high"};

std::string basis_of(int nodal_diameter) {
  return "/nodal_diameter/" + std::to_string(nodal_diameter) + "/basis";
}

std::string displacement_name(int power) {
  return "/static/displacement_" + std::to_string(power);
}

Array<std::int32_t> list(const std::vector<int>& values) {
  return {{values.size()}, {values.begin(), values.end()}};
}

Array<std::int32_t> table(const Eigen::MatrixXi& columns) {
  return {{static_cast<std::size_t>(columns.cols()), static_cast<std::size_t>(columns.rows())},
          {columns.data(), columns.data() + columns.size()}};
}

std::vector<int> read_list(const Hdf5File& file, const std::string& name, Eigen::Index limit) {
  const Array<std::int32_t> array = file.read_integers(name);
  if (array.shape.size() != 1) file.refuse(name, " must have one axis");
  for (const std::int32_t value : array.values)
    if (value < 0 || value >= limit) file.refuse(name, " names ", value, ", of 0 .. ", limit - 1);
  return {array.values.begin(), array.values.end()};
}

Eigen::Matrix3Xd read_vectors(const Hdf5File& file, const std::string& name) {
  const Eigen::MatrixXd rows = file.read_matrix(name);
  if (rows.cols() != 3) file.refuse(name, " must have three columns");
  return rows.transpose();
}

Eigen::MatrixXi read_cells(const Hdf5File& file, Eigen::Index nodes) {
  const std::string name = "/cells";
  const Array<std::int32_t> array = file.read_integers(name);
  if (array.shape.size() != 2 || array.shape[1] > 27 || !is_cell_kind(static_cast<int>(array.shape[1])))
    file.refuse(name, " must have ", cell_node_counts(), " columns");
  Eigen::MatrixXi cells = Eigen::Map<const Eigen::MatrixXi>(
      array.values.data(), static_cast<Eigen::Index>(array.shape[1]), static_cast<Eigen::Index>(array.shape[0]));
  for (Eigen::Index cell = 0; cell < cells.cols(); ++cell) {
    const auto listed = nodes_of(cells, cell);
    if (!is_cell_kind(static_cast<int>(listed.size())))
      file.refuse(name, " has a cell of ", listed.size(), " nodes; it must have ", cell_node_counts());
    for (const int node : listed)
      if (node < 0 || node >= nodes) file.refuse(name, " names node ", node, ", of 0 .. ", nodes - 1);
  }
  return cells;
}

void read_static_displacement(const Hdf5File& file, SectorFields& sector) {
  std::vector<Eigen::Matrix3Xd>& terms = sector.static_displacement.terms;
  for (int k = 1; k <= 2 || file.exists(displacement_name(k)); ++k) {
    terms.push_back(read_vectors(file, displacement_name(k)));
    if (terms.back().cols() != sector.nodes.cols())
      file.refuse(displacement_name(k), " must have a row for each node");
  }
  if (file.members("/static").size() != terms.size())
    file.refuse("/static must hold displacement_1, _2, and _3, _4, ... without a gap, and nothing else");
}

/// Stresses at the cuts are means over both sides, so that wrong partners would spoil them.
void check_cuts(const Hdf5File& file, const SectorFields& sector) {
  const std::vector<int>&low = sector.node_set("cyclic_low"), &high = sector.node_set("cyclic_high");
  if (low.size() != high.size()) file.refuse("/node_set/cyclic_high must pair with cyclic_low");
  if (low.empty() || sector.sector_count < 2) return;
  const double reach = widest_mismatch * sector.nodes.topRows<2>().colwise().norm().maxCoeff();
  const Eigen::AngleAxisd turn(2 * std::numbers::pi / sector.sector_count, Eigen::Vector3d::UnitZ());
  for (std::size_t k = 0; k < low.size(); ++k)
    if ((turn * sector.nodes.col(low[k]) - sector.nodes.col(high[k])).norm() > reach)
      file.refuse("/node_set/cyclic_high lists node ", high[k], " at place ", k, ", which is not where node ", low[k],
                  " of cyclic_low comes after a turn by 360/", sector.sector_count,
                  " degrees; both list partners in the same order");
}

/// Each node or cell is listed once; only `contact` may repeat nodes, those nearest to the centres of segments.
void check_groups(const Hdf5File& file, const SectorFields& sector) {
  for (const auto& [name, nodes] : sector.node_sets)
    if (const int node = listed_twice(nodes); name != "contact" && node >= 0)
      file.refuse("/node_set/", name, " lists node ", node, " twice");
  if (const auto [first, second] = equal_cells(listed_cells(sector.cells)); first >= 0)
    file.refuse("/cells lists cell ", first, " (from 0) again as ", second);
  check_cuts(file, sector);
  NamedLists tips;
  if (const auto line = sector.node_sets.find("contact_line"); line != sector.node_sets.end())
    tips["main_blade"] = line->second;
  if (const std::string wrong = wrong_parts(sector.cells, sector.parts, tips); !wrong.empty())
    file.refuse("/part: ", wrong);
}

SectorFields read_sector(const Hdf5File& file) {
  SectorFields sector;
  sector.sector_count = file.integer_attribute("/", "sector_count");
  sector.mesh_digest = file.text_attribute("/", "mesh_digest");
  sector.young = file.number_attribute("/", "young_modulus");
  sector.poisson = file.number_attribute("/", "poisson_ratio");
  sector.density = file.number_attribute("/", "density");
  if (!(sector.young > 0 && sector.density > 0)) file.refuse("/ young_modulus and density must be above 0");
  if (!(sector.poisson > -1 && sector.poisson < 0.5))
    file.refuse("/ poisson_ratio must be above -1 and below 0.5, where a material is incompressible");
  sector.nodes = read_vectors(file, "/nodes");
  sector.cells = read_cells(file, sector.nodes.cols());
  for (const char* name : required_sets)
    if (!file.exists(std::string("/node_set/") + name)) file.refuse("/node_set/", name, " is missing");
  for (const std::string& name : file.members("/node_set"))
    sector.node_sets[name] = read_list(file, "/node_set/" + name, sector.nodes.cols());
  if (file.exists("/part"))
    for (const std::string& name : file.members("/part"))
      sector.parts[name] = read_list(file, "/part/" + name, sector.cells.cols());
  read_static_displacement(file, sector);
  return sector;
}

Eigen::VectorXd read_cell_errors(const Hdf5File& file, const std::string& of, Eigen::Index cells) {
  const std::string name = cell_errors_group + of;
  Eigen::VectorXd errors = file.read_vector(name);
  if (errors.size() != cells) file.refuse(name, " must have a number for each cell");
  return errors;
}

template <class Values>
void add(Digest& digest, const Values& values) {
  digest.add(values.data(), static_cast<std::size_t>(values.size()));
}

/// A name for all of a sector's numbers, which tells a file that was damaged or changed.
std::string digest(const SectorFields& sector) {
  Digest digest;
  digest.add(sector.sector_count);
  for (const double number : {sector.young, sector.poisson, sector.density}) digest.add(number);
  add(digest, sector.nodes);
  add(digest, sector.cells);
  for (const NamedLists* lists : {&sector.node_sets, &sector.parts})
    for (const auto& [name, list] : *lists) {
      digest.add(name);
      add(digest, list);
    }
  for (int k = 1; k <= sector.static_displacement.highest(); ++k)
    add(digest, sector.static_displacement.coefficient(k));
  return digest.digits();
}

void require_digest(const Hdf5File& file, const SectorFields& sector) {
  if (file.has_attribute("/", "digest") && file.text_attribute("/", "digest") != digest(sector))
    throw FileError(file.path() +
                    ": its sector is not the one that was written (attribute `digest`): it was damaged or changed; "
                    "reduce again, or delete that attribute if the change was meant");
}

}  // namespace

FieldsWriter::FieldsWriter(const std::filesystem::path& path, const std::string& generator)
    : file_(Hdf5File::create(path)) {
  file_.set_schema(fields_schema, fields_schema_version, generator);
}

void FieldsWriter::close(const std::string& model_digest) {
  file_.set_attribute("/", "model_digest", model_digest);
  file_.close();
}

void FieldsWriter::write_sector(const SectorFields& sector) {
  nodes_ = static_cast<std::size_t>(sector.nodes.cols());
  file_.set_attribute("/", "sector_count", sector.sector_count);
  file_.set_attribute("/", "mesh_digest", sector.mesh_digest);
  file_.set_attribute("/", "young_modulus", sector.young);
  file_.set_attribute("/", "poisson_ratio", sector.poisson);
  file_.set_attribute("/", "density", sector.density);
  file_.set_attribute("/", "digest", digest(sector));
  file_.write("/nodes", Eigen::MatrixXd(sector.nodes.transpose()), "m");
  file_.write("/cells", table(sector.cells), "1");
  for (const auto& [name, nodes] : sector.node_sets) file_.write("/node_set/" + name, list(nodes), "1");
  for (const auto& [name, cells] : sector.parts) file_.write("/part/" + name, list(cells), "1");
  for (int k = 1; k <= sector.static_displacement.highest(); ++k)
    file_.write(displacement_name(k), Eigen::MatrixXd(sector.static_displacement.coefficient(k).transpose()),
                "m s^" + std::to_string(2 * k));
}

void FieldsWriter::write_basis(int nodal_diameter, Eigen::Index dofs, bool standing, const Shape& shape) {
  const std::string name = basis_of(nodal_diameter);
  file_.make_slices(name, {static_cast<std::size_t>(dofs), nodes_, 3},
                    standing ? Hdf5File::Number::real : Hdf5File::Number::complex, "m in contact dofs");
  std::vector<std::complex<float>> values;
  for (Eigen::Index k = 0; k < dofs; ++k) {
    const Eigen::VectorXcf single = shape(k).cast<std::complex<float>>();
    values.assign(single.data(), single.data() + single.size());
    file_.write_slice(name, static_cast<std::size_t>(k), values);
  }
}

void FieldsWriter::write_mesh_error(const Eigen::VectorXd& frequency, const Eigen::VectorXd& compliance) {
  file_.write(std::string(cell_errors_group) + "/frequency", frequency, "1");
  file_.write(std::string(cell_errors_group) + "/compliance", compliance, "1");
}

FieldsReader::FieldsReader(const std::filesystem::path& path) : file_(Hdf5File::open(path)) {
  file_.require_schema(fields_schema, fields_schema_version);
  sector_ = read_sector(file_);
  model_digest_ = file_.text_attribute("/", "model_digest");
  if (file_.exists(cell_errors_group)) {
    frequency_errors_ = read_cell_errors(file_, "/frequency", sector_.cells.cols());
    compliance_errors_ = read_cell_errors(file_, "/compliance", sector_.cells.cols());
  }
  for (int n = 0; n <= sector_.sector_count / 2; ++n) dofs(n);
  check_groups(file_, sector_);
  require_digest(file_, sector_);
}

Eigen::Index FieldsReader::dofs(int nodal_diameter) const {
  const std::string name = basis_of(nodal_diameter);
  const std::vector<std::size_t> shape = file_.shape_of(name);
  if (shape.size() != 3 || shape[1] != static_cast<std::size_t>(sector_.nodes.cols()) || shape[2] != 3)
    file_.refuse(name, " must have the axes model dof, node, component");
  return static_cast<Eigen::Index>(shape[0]);
}

void FieldsReader::read_shape(int nodal_diameter, Eigen::Index dof, const Eigen::Ref<Eigen::VectorXcf>& shape) const {
  std::vector<bool>& sound = sound_[nodal_diameter];
  const auto place = static_cast<std::size_t>(dof);
  if (sound.size() <= place) sound.resize(place + 1);
  file_.read_slice(basis_of(nodal_diameter), place, shape,
                   sound[place] ? Hdf5File::Check::before : Hdf5File::Check::full);
  sound[place] = true;
}

Eigen::VectorXcd FieldsReader::shape(int nodal_diameter, Eigen::Index dof) const {
  Eigen::VectorXcf shape(3 * sector_.nodes.cols());
  read_shape(nodal_diameter, dof, shape);
  return shape.cast<std::complex<double>>();
}

namespace {

/// sum += shapes both; `both` holds the factors of the real parts of the shapes, then of their imaginary ones.
/// Threads share blocks of rows, so that the result does not depend on their number.
void add_shapes(const Eigen::Ref<const Eigen::MatrixXcf>& shapes, const Eigen::MatrixXd& both, Eigen::MatrixXd& sum) {
  work_on_pieces(sum.rows(), rows_at_once, 0, [&](Eigen::Index first, Eigen::Index count) {
    const auto rows = shapes.middleRows(first, count);
    Eigen::MatrixXd block(count, both.rows());
    block << rows.real().cast<double>(), rows.imag().cast<double>();
    sum.middleRows(first, count).noalias() += block * both;
  });
}

}  // namespace

Eigen::MatrixXcd FieldsReader::expand(int nodal_diameter, const Eigen::MatrixXcd& amplitudes) const {
  const std::string name = basis_of(nodal_diameter);
  if (amplitudes.rows() != dofs(nodal_diameter))
    file_.refuse(name, " has ", dofs(nodal_diameter), " dofs, the model has ", amplitudes.rows(),
                 "; give the fields that were written with the model");
  // Real and imaginary parts beside each other: Eigen multiplies real numbers faster than complex ones.
  const Eigen::Index size = 3 * sector_.nodes.cols(), columns = amplitudes.cols();
  Eigen::MatrixXd fields = Eigen::MatrixXd::Zero(size, 2 * columns);
  Eigen::MatrixXcf shapes(size, slices_at_once);
  for (Eigen::Index first = 0; first < amplitudes.rows(); first += slices_at_once) {
    const Eigen::Index count = std::min(slices_at_once, amplitudes.rows() - first);
    for (Eigen::Index k = 0; k < count; ++k) read_shape(nodal_diameter, first + k, shapes.col(k));
    const auto factors = amplitudes.middleRows(first, count);
    Eigen::MatrixXd both(2 * count, 2 * columns);
    both << factors.real(), factors.imag(), -factors.imag(), factors.real();
    add_shapes(shapes.leftCols(count), both, fields);
  }
  Eigen::MatrixXcd whole(size, columns);
  whole.real() = fields.leftCols(columns);
  whole.imag() = fields.rightCols(columns);
  return whole;
}

}  // namespace tiprub
