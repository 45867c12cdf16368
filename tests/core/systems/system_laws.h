#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/phase_plane/system.h"

namespace dualarm {

/// Systems of one kind, with names for reports.
struct SystemFamily {
  std::string name;
  std::vector<std::pair<std::string, std::shared_ptr<const System>>> systems;
};

inline void PrintTo(const SystemFamily& family, std::ostream* out) { *out << family.name; }

/// What the phase plane assumes of a System (core/phase_plane/system.h), as tests. To hold new Systems to them, add
/// system_laws.cc, system_position_laws.cc and system_samples.cc to the test's sources and
/// INSTANTIATE_TEST_SUITE_P(Name, SystemLaws, Values(family, ...), family_name).
class SystemLaws : public testing::TestWithParam<SystemFamily> {
 protected:
  /// Calls law(system) for each of the family.
  template <class Law>
  void hold_all_to(const Law& law) const {
    for (const auto& [name, system] : GetParam().systems) {
      SCOPED_TRACE(name);
      law(*system);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
};

inline std::string family_name(const testing::TestParamInfo<SystemFamily>& family) { return family.param.name; }

}  // namespace dualarm
