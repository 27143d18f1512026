// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/operators/memory_need.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <vector>

#include "cases/program/machine.h"
#include "tests/cases/complaint.h"
#include "tests/reduce/test_rotor.h"

namespace tiprub::reduce {
namespace {

TEST(MemoryNeed, CountsAtLeastWhatIsThere) {
  const test::TestRotor rotor = test::tip_rotor(test::skewed_annulus(5));
  const SectorDofs& dofs = rotor.dofs();
  const Holdings held{.factors = 2, .stiffnesses = 3, .columns = 40, .threads = 1};
  const MemoryNeed need = memory_need(rotor.mesh(), dofs, held);
  // One nodal diameter's vectors; two factors, each at least as full as its dense end.
  EXPECT_GE(need.bases, 40 * 16.0 * dofs.independent());
  EXPECT_GE(need.factor, 2 * 8.0 * dofs.interface() * dofs.interface() / 2);
  EXPECT_GT(need.matrices, 0.0);
  const auto other = [&](int stiffnesses, int columns, int threads, double mesh_error = 0) {
    return memory_need(
        rotor.mesh(), dofs,
        {.factors = 2, .stiffnesses = stiffnesses, .columns = columns, .mesh_error = mesh_error, .threads = threads});
  };
  EXPECT_NEAR(other(3, 40, 1, 5e5).matrices, need.matrices + 5e5, 1);
  EXPECT_GE(other(3, 80, 1).bases, need.bases + 40 * 16.0 * dofs.independent());
  EXPECT_GT(other(3, 40, 2).bases, need.bases);
  EXPECT_GT(other(9, 40, 1).matrices, need.matrices);
}

/// Symptom: a reduction of 112,000 dofs kept 4.9 GiB to its end, of which it used 1.4 GiB, because a library that
/// comes with deal.II forbids malloc to return memory.
TEST(Memory, IsReturnedWhenItIsFreed) {
#ifdef TIPRUB_SANITIZED
  GTEST_SKIP() << "the sanitizer's malloc has no statistics";
#endif
  constexpr std::size_t kept = std::size_t{512} << 20, block = std::size_t{1} << 30;
  return_freed_memory();
  const auto held = [] { return mallinfo2().arena + mallinfo2().hblkhd; };
  const std::size_t before = held();
  {
    const std::vector<char> factor(block);
    EXPECT_GE(held(), block);
    EXPECT_EQ(factor.back(), 0);
  }
  EXPECT_LE(held(), before + kept);
}

TEST(MemoryNeed, IsComparedWithWhatThereIs) {
  constexpr double gib = 1024.0 * 1024 * 1024;
  const MemoryNeed need{.factor = 2 * gib, .bases = 1 * gib, .matrices = 0.5 * gib, .threads = 1 * gib};
  constexpr FactorMethod method = FactorMethod::cholmod;
  EXPECT_NO_THROW(require_memory(need, method, 3.5 * gib, 4.5 * gib));
  const std::string message = complaint<RunError>([&] { require_memory(need, method, 3.4 * gib, 9 * gib); });
  EXPECT_EQ(message.rfind("not enough memory: about 3.50 GiB are needed (factor 2.00 GiB, bases 1.00 GiB, matrices "
                          "0.50 GiB), 3.40 GiB are available; ",
                          0),
            0u)
      << message;
  // The BLAS's buffers count where mapping is limited only.
  const std::string limited = complaint<RunError>([&] { require_memory(need, method, 9 * gib, 4.4 * gib); });
  EXPECT_EQ(limited.rfind("not enough memory: about 4.50 GiB are needed (factor 2.00 GiB, bases 1.00 GiB, matrices "
                          "0.50 GiB, threads 1.00 GiB), 4.40 GiB are available under ulimit; ",
                          0),
            0u)
      << limited;
}

TEST(MemoryNeed, DecidesWhatFactorizesAndWhere) {
  constexpr double gib = 1024.0 * 1024 * 1024;
  const MemoryNeed need{.factor = 9 * gib,
                        .bases = 1 * gib,
                        .matrices = 1 * gib,
                        .threads = 0,
                        .sparse_factor = 4 * gib,
                        .interface = 0.2 * gib,
                        .factors = 2};
  const auto chosen = [&](Factorization wanted, double available) {
    return choose_method(need, wanted, available * gib, 100 * gib);
  };
  EXPECT_EQ(chosen(Factorization::automatic, 11.1), FactorMethod::cholmod);
  EXPECT_EQ(chosen(Factorization::automatic, 10.9), FactorMethod::mumps_on_disk);
  EXPECT_EQ(chosen(Factorization::automatic, 1), FactorMethod::mumps_on_disk);  // and is refused
  EXPECT_EQ(chosen(Factorization::cholmod, 1), FactorMethod::cholmod);
  EXPECT_EQ(chosen(Factorization::mumps, 30), FactorMethod::mumps);
  EXPECT_EQ(chosen(Factorization::mumps, 10.9), FactorMethod::mumps_on_disk);
  EXPECT_DOUBLE_EQ(need.on_disk(FactorMethod::mumps_on_disk), 2 * (4 + 0.2) * gib);  // factors and Schur complements
  const std::string message =
      complaint<RunError>([&] { require_memory(need, FactorMethod::cholmod, 10.9 * gib, 100 * gib); });
  EXPECT_NE(message.find("; factorization = \"mumps\" would need "), std::string::npos) << message;
}

}  // namespace
}  // namespace tiprub::reduce
