// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/record/run_times.h"

#include <sched.h>
#include <sys/resource.h>

#include <ostream>

#include "cases/program/output_file.h"

namespace tiprub {

namespace {

/// [s] of the user's and the system's work.
double processor_time(int whose) {
  constexpr double microsecond = 1e-6;
  rusage used{};
  getrusage(whose, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         microsecond * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace

void RunTimes::write(const std::string& program, const std::filesystem::path& path) const {
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  OutputFile output(path);
  write_file(output.scratch(), [&](std::ostream& stream) {
    stream << "program,wall time [s],processor time [s],processors\n"
           << program << ',' << wall << ',' << processor_time(RUSAGE_SELF) + processor_time(RUSAGE_CHILDREN) << ','
           << processors() << '\n';
  });
  output.commit();
}

}  // namespace tiprub
