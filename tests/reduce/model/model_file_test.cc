// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/reduced_model_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <numbers>

#include "reduce/model/hdf5_file.h"
#include "tests/cases/complaint.h"
#include "tests/cases/full_disk.h"
#include "tests/reduce/model/some_model.h"

namespace tiprub::reduce {
namespace {

namespace fs = std::filesystem;
using test::some_model;
using test::write_one_mass;

class ModelFile : public ::testing::Test {
 protected:
  ModelFile() : folder_(fs::path(::testing::TempDir()) / ("tiprub_model_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~ModelFile() override { fs::remove_all(folder_); }

  fs::path path(const std::string& name = "model.h5") const { return folder_ / name; }
  std::string bytes(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// What reading says about a file after this model has been written to it.
  std::string complaint_about(const ReducedModel& model) const {
    write_model(model, path(), "test");
    return complaint<RunError>([&] { read_model(path()); });
  }
  /// What reading says about a file of the right schema that holds whatever `fill` writes.
  template <class Fill>
  std::string complaint_about_file(const Fill& fill) const {
    {
      Hdf5File file = Hdf5File::create(path());
      fill(file);
    }
    return complaint<RunError>([&] { read_model(path()); });
  }
  void write_ones() const {
    Hdf5File file = Hdf5File::create(path());
    file.make_slices("/basis", {1, 300}, Hdf5File::Number::real, "1");
    file.write_slice("/basis", 0, std::vector<std::complex<float>>(300, 1.0F));
  }
  Eigen::VectorXcf first_slice(Hdf5File::Check check = Hdf5File::Check::full) const {
    Eigen::VectorXcf slice(300);
    Hdf5File::open(path()).read_slice("/basis", 0, slice, check);
    return slice;
  }

  fs::path folder_;
};

void expect_same(const ReducedModel& a, const ReducedModel& b) {
  EXPECT_EQ(a.sector_count, b.sector_count);
  EXPECT_EQ(a.speed_max, b.speed_max);
  EXPECT_EQ(a.prestress, b.prestress);
  EXPECT_EQ(a.spin_softening, b.spin_softening);
  EXPECT_EQ(a.effects, b.effects);
  EXPECT_EQ(a.mesh_digest, b.mesh_digest);
  EXPECT_EQ(a.provenance, b.provenance);
  EXPECT_EQ(a.contact.kind, b.contact.kind);
  EXPECT_EQ(a.contact.position, b.contact.position);
  EXPECT_EQ(a.contact.normal, b.contact.normal);
  EXPECT_EQ(a.contact.arc_length, b.contact.arc_length);
  EXPECT_EQ(a.contact.static_shift.terms, b.contact.static_shift.terms);
  ASSERT_EQ(a.nodal_diameters.size(), b.nodal_diameters.size());
  for (std::size_t n = 0; n < a.nodal_diameters.size(); ++n) {
    EXPECT_EQ(a.nodal_diameters[n].K.terms, b.nodal_diameters[n].K.terms);
    EXPECT_EQ(a.nodal_diameters[n].M, b.nodal_diameters[n].M);
  }
  EXPECT_EQ(a.verification.shape_balance, b.verification.shape_balance);
  EXPECT_EQ(a.verification.speeds, b.verification.speeds);
  EXPECT_EQ(a.verification.unreduced, b.verification.unreduced);
  EXPECT_EQ(a.verification.reduced, b.verification.reduced);
}

TEST_F(ModelFile, RoundTripsBitForBit) {
  write_model(some_model(), path(), "test");
  expect_same(read_model(path()), some_model());
}

TEST_F(ModelFile, SaysWhatItsContactUnknownsAre) {
  ReducedModel model = some_model();
  model.contact.kind = ContactKind::segments;
  write_model(model, path(), "test");
  expect_same(read_model(path()), model);
  EXPECT_NE(digest(model), digest(some_model()));
  EXPECT_EQ(complaint_about_file([](Hdf5File& file) {
              write_one_mass(file);
              file.set_attribute("/", "contact", std::string("lines"));
            }),
            path().string() + ": attribute contact is \"lines\", must be \"points\" or \"segments\"");
}

TEST_F(ModelFile, SaysWhichNodesStandOnTheSplitter) {
  ReducedModel model = some_model();
  ContactLine& contact = model.contact;
  contact.splitter_nodes = 1;
  for (Eigen::MatrixX3d* table :
       {&contact.position, &contact.normal, &contact.static_shift[1], &contact.static_shift[2]})
    *table = table->replicate(2, 1).eval();
  contact.position(1, 1) += 0.1;
  contact.arc_length = Eigen::VectorXd::Zero(2);
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(6, 6);
  for (NodalDiameterModel& matrices : model.nodal_diameters) matrices = {{{1e6 * one, one, one}}, one};
  write_model(model, path(), "test");
  expect_same(read_model(path()), model);
  EXPECT_EQ(read_model(path()).contact.splitter_nodes, 1);
  const std::string name = digest(model);
  contact.splitter_nodes = 0;
  EXPECT_NE(digest(model), name);
  for (const auto& blade : {Eigen::VectorXd::Constant(1, 1.0).eval(), Eigen::VectorXd::Constant(1, 2.0).eval(),
                            Eigen::VectorXd::Zero(2).eval()})
    EXPECT_EQ(complaint_about_file([&](Hdf5File& file) {
                write_one_mass(file);
                file.write("/contact/blade", blade, "1");
              }),
              path().string() +
                  ": /contact/blade must hold, for each of the 1 contact nodes, 0 for those of the main "
                  "blade, which come first, and 1 for the splitter's");
}

/// K and the static shift of large displacements go on with Omega^6, Omega^8, ...
TEST_F(ModelFile, CarriesAnyNumberOfTerms) {
  ReducedModel model = some_model();
  for (NodalDiameterModel& matrices : model.nodal_diameters)
    for (const double factor : {1e-3, 1e-6}) matrices.K.terms.push_back(factor * matrices.K[2]);
  model.contact.static_shift.terms.emplace_back(Eigen::RowVector3d(1e-27, 0.0, 2e-28));
  model.contact.static_shift.terms.emplace_back(Eigen::RowVector3d(-1e-34, 3e-35, 0.0));
  write_model(model, path(), "test");
  const ReducedModel read = read_model(path());
  expect_same(read, model);
  EXPECT_EQ(read.nodal_diameters[1].K.terms.size(), 5u);
  EXPECT_EQ(Hdf5File::open(path()).text_attribute("/contact/static_shift_4", "unit"), "m s^8");
  const std::string name = digest(model);
  model.contact.static_shift[4](0, 0) *= 2;
  EXPECT_NE(digest(model), name);
}

TEST_F(ModelFile, RefusesAStaticShiftWithAGap) {
  const Eigen::MatrixXd shift = Eigen::RowVector3d(1.0, 0.0, 0.0);
  const auto complaint = [&](const std::string& name, const Eigen::MatrixXd& values, const std::string& unit) {
    return complaint_about_file([&](Hdf5File& file) {
      write_one_mass(file);
      file.write("/contact/" + name, values, unit);
    });
  };
  EXPECT_EQ(complaint("static_shift_3", shift, "m s^6"), "");
  EXPECT_EQ(read_model(path()).contact.static_shift(2.0), Eigen::MatrixX3d(64.0 * shift));
  EXPECT_EQ(complaint("static_shift_4", shift, "m s^8"),
            path().string() +
                ": /contact/static_shift_4 is not known; the static shift is static_shift_1, _2, and "
                "_3, _4, ... without a gap");
  EXPECT_EQ(complaint("static_shift_3", shift, "m"),
            path().string() +
                ": /contact/static_shift_3 has the unit \"m\", must be \"m s^6\" (SI), or no attribute `unit`");
  EXPECT_EQ(complaint("static_shift_3", shift.leftCols(2), "m s^6"),
            path().string() + ": /contact/static_shift_3 must have three columns: r, theta, z");
  EXPECT_EQ(complaint("static_shift_3", shift.replicate(2, 1), "m s^6"),
            path().string() + ": /contact: every table must have 1 rows");
}

/// An attribute holds 64 KB: a case with a long table lost the reduction that it had taken.
TEST_F(ModelFile, CarriesACaseOfAnyLength) {
  ReducedModel model = some_model();
  model.provenance = std::string(300000, 'x') + "end";
  write_model(model, path(), "test");
  EXPECT_TRUE(read_model(path()).provenance == model.provenance);
}

TEST_F(ModelFile, ReadsTheCaseOfOlderFilesAndNone) {
  {
    Hdf5File file = Hdf5File::create(path());
    write_one_mass(file);
    file.set_attribute("/", "provenance", std::string("an older case"));
  }
  EXPECT_EQ(read_model(path()).provenance, "an older case");
  {
    Hdf5File file = Hdf5File::create(path());
    write_one_mass(file);
  }
  EXPECT_EQ(read_model(path()).provenance, "");
}

TEST_F(ModelFile, SameModelSameBytes) {
  write_model(some_model(), path("a.h5"), "test");
  sleep(1);  // a time in the file would show
  write_model(some_model(), path("b.h5"), "test");
  EXPECT_GT(bytes("a.h5").size(), 1000u);
  EXPECT_TRUE(bytes("a.h5") == bytes("b.h5"));
}

/// HDF5's destructors told of a full disk on stderr only, and what they left behind crashed at the program's exit.
TEST_F(ModelFile, SaysThatTheDiskIsFull) {
  write_model(some_model(), path(), "test");
  const auto size = static_cast<rlim_t>(fs::file_size(path()));
  constexpr int cuts = 40;
  for (int cut = 0; cut < cuts; ++cut) {
    fs::remove(path());
    const FullDisk disk(cut * size / cuts);
    const std::string message = complaint<RunError>([&] { write_model(some_model(), path(), "test"); });
    EXPECT_EQ(message.find(path().string() + ": "), 0u) << cut << message;
    EXPECT_NE(message.find("can't be written"), std::string::npos) << cut << message;
  }
  write_model(some_model(), path(), "test");
  expect_same(read_model(path()), some_model());
}

TEST_F(ModelFile, MayLeaveOutWhatIsZero) {
  EXPECT_EQ(complaint_about_file([](Hdf5File& file) { write_one_mass(file); }), "");
  const ReducedModel model = read_model(path());
  EXPECT_EQ(model.prestress, Prestress::given);
  EXPECT_EQ(model.nodal_diameters[0].K[2], Eigen::MatrixXcd::Zero(3, 3));
  EXPECT_EQ(model.contact.static_shift(50.0), Eigen::MatrixX3d::Zero(1, 3));
  EXPECT_NEAR(model.nodal_diameters[0].natural_frequencies(50.0)[0], 1 / std::numbers::pi, 1e-15);  // 2 rad/s
}

/// Symptom: a nonlinear model without spin softening was taken for one of unknown prestress, because both stood in
/// one text. Files that hold that text are still read.
TEST_F(ModelFile, TellsThePrestressAndTheSofteningApart) {
  const auto read_with = [&](const std::string& prestress) {
    EXPECT_EQ(complaint_about_file([&](Hdf5File& file) {
                write_one_mass(file);
                file.set_attribute("/", "prestress", prestress);
              }),
              "");
    return read_model(path());
  };
  const ReducedModel older = read_with("nonlinear, without spin softening");
  EXPECT_EQ(older.prestress, Prestress::nonlinear);
  EXPECT_EQ(older.spin_softening, SpinSoftening::off);
  EXPECT_EQ(older.stiffness_under_spin(), "nonlinear, without spin softening");
  EXPECT_EQ(read_with("linear").spin_softening, SpinSoftening::on);
}

TEST_F(ModelFile, KnowsWhatAModelByHandLeavesOut) {
  complaint_about_file([](Hdf5File& file) { write_one_mass(file); });
  const ReducedModel model = read_model(path());
  ASSERT_NE(find(model.effects, Effect::coriolis), nullptr);
  EXPECT_EQ(find(model.effects, Effect::coriolis)->treatment, Treatment::left_out);
  EXPECT_EQ(find(model.effects, Effect::contact_resolution)->reason, "1 contact nodes");
  EXPECT_EQ(find(model.effects, Effect::friction), nullptr);
}

TEST_F(ModelFile, RefusesWhatIsNoHdf5FileAndWhatIsNotThere) {
  EXPECT_EQ(complaint<RunError>([&] { read_model(path("none.h5")); }), path("none.h5").string() + ": no such file");
  std::ofstream(path()) << "not HDF5";
  EXPECT_EQ(complaint<RunError>([&] { read_model(path()); }),
            path().string() + ": is not an HDF5 file, or is damaged");
}

/// One byte of a stiffness: a model that is as good as any other to whoever only looks at shapes.
TEST_F(ModelFile, RefusesADamagedNumber) {
  write_model(some_model(), path(), "test");
  std::string all = bytes("model.h5");
  const double entry = some_model().contact.position(0, 2);
  const std::size_t at = all.find(std::string(reinterpret_cast<const char*>(&entry), sizeof(entry)));
  ASSERT_NE(at, std::string::npos);
  all[at] = static_cast<char>(all[at] ^ 1);
  std::ofstream(path(), std::ios::binary) << all;
  EXPECT_EQ(complaint<RunError>([&] { read_model(path()); }),
            path().string() +
                ": its numbers are not those that were written (attribute `digest`): it was damaged or changed; "
                "reduce again, or delete that attribute if the change was meant");
}

TEST_F(ModelFile, RefusesWhatItWouldLeaveOut) {
  for (const std::string name : {"K_1", "K9", "k1", "C"})
    EXPECT_EQ(complaint_about_file([&](Hdf5File& file) {
                write_one_mass(file);
                file.write("/nodal_diameter/0/" + name, Eigen::MatrixXd(Eigen::MatrixXd::Identity(3, 3)), "1");
              }),
              path().string() + ": /nodal_diameter/0/" + name +
                  " is not known; a nodal diameter holds M, K0, K1, K2, and K3, K4, ... without a gap");
}

/// Symptom: a mass a thousand times too large passed, though /verification of the same file said otherwise.
TEST_F(ModelFile, ComparesAModelOfOnesOwnWithItsVerification) {
  const auto complaint = [&](double hertz) {
    return complaint_about_file([&](Hdf5File& file) {
      write_one_mass(file);
      file.write("/verification/speed", Eigen::VectorXd(Eigen::VectorXd::Zero(1)), "rad/s");
      for (const std::string kind : {"unreduced", "reduced"})
        file.write("/verification/nodal_diameter/0/" + kind, Eigen::MatrixXd::Constant(1, 3, hertz).eval(), "Hz");
    });
  };
  EXPECT_EQ(complaint(1 / std::numbers::pi), "");
  EXPECT_EQ(complaint(10),
            path().string() +
                ": /verification/nodal_diameter/0/reduced has 10 Hz for mode 0 at 0 rad/s, but K and M of this nodal "
                "diameter give 0.31831 Hz; correct what is wrong, or leave out /verification");
}

TEST_F(ModelFile, RefusesOtherUnits) {
  EXPECT_EQ(
      complaint_about_file([](Hdf5File& file) { write_one_mass(file, "mm"); }),
      path().string() + ": /contact/arc_length has the unit \"mm\", must be \"m\" (SI), or no attribute `unit`");
}

TEST_F(ModelFile, RefusesHalfAFile) {
  write_model(some_model(), path(), "test");
  fs::resize_file(path(), fs::file_size(path()) / 2);
  EXPECT_EQ(complaint<RunError>([&] { read_model(path()); }),
            path().string() + ": is not an HDF5 file, or is damaged");
}

/// HDF5 1.10 follows the address of a group's names to wherever it points, and dies there.
TEST_F(ModelFile, SurvivesWhatHdf5DiesOf) {
  write_model(some_model(), path(), "test");
  std::string all = bytes("model.h5");
  constexpr std::size_t address_of_names = 24;
  for (std::size_t at = all.find("HEAP"); at != std::string::npos; at = all.find("HEAP", at + 1))
    all.replace(at + address_of_names, sizeof(void*), sizeof(void*), '\xff');
  std::ofstream(path(), std::ios::binary) << all;
  EXPECT_TRUE(
      complaint<RunError>([&] { read_model(path()); }).starts_with(path().string() + ": is not an HDF5 file"));
}

/// HDF5 1.10 reads as many bytes of a chunk as it should have, however few the file says it has.
TEST_F(ModelFile, SurvivesChunksThatAreTooSmall) {
  write_ones();
  EXPECT_EQ(first_slice(), Eigen::VectorXcf::Ones(300));
  std::string all = bytes("model.h5");
  constexpr std::size_t size_of_first_chunk = 24;
  all.at(all.find("TREE\x01") + size_of_first_chunk + 1) = 0;
  std::ofstream(path(), std::ios::binary) << all;
  EXPECT_EQ(complaint<RunError>([&] { Hdf5File::open(path()); }),
            path().string() + ": basis: is damaged: its numbers lie beyond its end");
}

/// Symptom: a byte that had changed in the basis of fields.h5 changed the stress, and nothing was said.
TEST_F(ModelFile, NoticesADamagedSlice) {
  write_ones();
  std::string all = bytes("model.h5");
  all.at(all.find(std::string("\0\0\x80\x3f\0\0\x80\x3f", 8)) + 3) = '\x40';
  std::ofstream(path(), std::ios::binary) << all;
  EXPECT_EQ(complaint<RunError>([&] { first_slice(); }),
            path().string() + ": /basis: slice 0 is damaged, or holds neither real nor {r, i} numbers");
  EXPECT_NE(first_slice(Hdf5File::Check::before), Eigen::VectorXcf::Ones(300));
}

/// A shape costs nothing in a file, and took minutes and all memory to be filled with zeros.
TEST_F(ModelFile, RefusesAHollowDataset) {
  EXPECT_EQ(complaint_about_file([](Hdf5File& file) {
              write_one_mass(file);
              file.make_slices("/verification/speed", {1U << 30}, Hdf5File::Number::real, "rad/s");
            }),
            path().string() + ": /verification/speed: takes more memory than there is, or than the file could fill");
}

TEST_F(ModelFile, RefusesAnotherSchemaOrVersion) {
  EXPECT_EQ(complaint_about_file([](Hdf5File&) {}),
            path().string() + ": has no schema; expected tiprub-model version 1");
  EXPECT_EQ(complaint_about_file([](Hdf5File& file) { file.set_schema("tiprub-response", 1, "x"); }),
            path().string() + ": is tiprub-response version 1, expected tiprub-model version 1");
  EXPECT_EQ(complaint_about_file([](Hdf5File& file) { file.set_schema("tiprub-model", 2, "x"); }),
            path().string() + ": is tiprub-model version 2, expected tiprub-model version 1");
}

TEST_F(ModelFile, RefusesAMissingDataset) {
  const std::string message = complaint_about_file([](Hdf5File& file) {
    file.set_schema("tiprub-model", 1, "by hand");
    file.set_attribute("/", "sector_count", 1);
    file.set_attribute("/", "speed_max", 100.0);
  });
  EXPECT_EQ(message, path().string() + ": /contact/arc_length: is missing");
  ReducedModel model = some_model();
  model.nodal_diameters.pop_back();
  EXPECT_EQ(complaint_about(model), path().string() + ": /nodal_diameter/2/M: is missing");
}

TEST_F(ModelFile, RefusesValuesThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ReducedModel model = some_model();
  model.nodal_diameters[0].K[0](1, 2) = nan;  // written real
  EXPECT_EQ(complaint_about(model),
            path().string() + ": /nodal_diameter/0/K0: value 7 (row-major, from 0) is not finite");
  model = some_model();
  model.nodal_diameters[1].M(1, 2) = nan;  // written complex
  EXPECT_EQ(complaint_about(model), path().string() + ": /nodal_diameter/1/M: row 1, column 2 is not finite");
  model = some_model();
  model.speed_max = nan;
  EXPECT_EQ(complaint_about(model), path().string() + ": /: attribute speed_max is not finite");
  model = some_model();
  model.verification.reduced[1](0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_NE(complaint_about(model).find("/verification/nodal_diameter/1/reduced"), std::string::npos);
}

}  // namespace
}  // namespace tiprub::reduce
