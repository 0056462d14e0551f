#include "sim/results/csv.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <system_error>

#include "sim/results/file.hpp"
#include "tests/sim/results/made_results.hpp"

namespace wale {
namespace {

TEST(Csv, HasOneColumnForEachEnergyOfThePulledStage) {
  std::istringstream lines(curve_csv(testing::made_results()));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "strain,stress_MPa,force_N,force_per_wale_N,energy_stretch_J,energy_bend_J");
  std::getline(lines, line);
  EXPECT_EQ(line, "0,0,0,0,0,-0");
  std::getline(lines, line);
  EXPECT_EQ(line, "0.15,0.00200625,0.05,0.0166666667,0.00015,-0");
  int rest = 0;
  while (std::getline(lines, line)) ++rest;
  EXPECT_EQ(rest, 3);
}

TEST(Csv, HasTheResidualOfAQuasiStaticStage) {
  Results results;
  append_row(results.samples, {{"strain", "", 0}});
  append_row(results.samples, {{"strain", "", 0.1}, {"energy.bend", "J", 2}, {"residual", "N", 1e-4}});
  EXPECT_EQ(curve_csv(results),
            "strain,stress_MPa,force_N,force_per_wale_N,residual_N,energy_bend_J\n"
            "0,nan,nan,nan,nan,nan\n0.1,nan,nan,nan,0.0001,2\n");
}

TEST(Csv, SaysNanForANumberThatLacks) {
  Results results;
  append_row(results.samples, {{"strain", "", 0.1}, {"energy.grip.top", "J", 2}});
  EXPECT_EQ(curve_csv(results), "strain,stress_MPa,force_N,force_per_wale_N,energy_grip_top_J\n0.1,nan,nan,nan,2\n");
}

TEST(Csv, OfADeformationHasStrainsAndStressesByDirection) {
  Results results;
  append_row(results.samples, {{"strain.course", "", 0},
                               {"strain.wale", "", 0.25},
                               {"strain.shear", "", -0.5},
                               {"stress.course", "Pa", 1e6},
                               {"stress.wale", "Pa", 2e6},
                               {"stress.shear", "Pa", -3e6},
                               {"energy.bend", "J", 4}});
  EXPECT_EQ(curve_csv(results),
            "strain_wale,stress_wale_MPa,strain_course,stress_course_MPa,strain_shear,stress_shear_MPa,energy_bend_J\n"
            "0.25,2,0,1,-0.5,-3,4\n");
}

TEST(Csv, OfAFabricThatIsOnlyPressedHasTheForceOnTheObstacleByTime) {
  Results results;
  append_row(results.samples, {{"stage", "1", 0}, {"t", "s", 1}, {"force.obstacle.z", "N", 9}});
  append_row(results.samples, {{"stage", "1", 1}, {"t", "s", 0}, {"force.obstacle.z", "N", 0}});
  append_row(results.samples, {{"stage", "1", 1}, {"t", "s", 0.5}, {"force.obstacle.z", "N", -2}});
  append_row(results.samples, {{"stage", "1", 2}, {"t", "s", 1}});
  EXPECT_EQ(curve_csv(results), "t_s,force_obstacle_z_N\n0,0\n0.5,-2\n");
}

TEST(Csv, OfAPulledFabricThatLeansOnAnObstacleHasBoth) {
  Results results;
  append_row(results.samples, {{"stage", "1", 0}, {"strain", "1", 0.1}, {"force.obstacle.2.x", "N", 3}});
  EXPECT_EQ(curve_csv(results), "strain,stress_MPa,force_N,force_per_wale_N,force_obstacle_2_x_N\n0.1,nan,nan,nan,3\n");
}

TEST(Csv, OfARunWithoutAPullIsItsHeader) { EXPECT_EQ(curve_csv({}), "strain,stress_MPa,force_N,force_per_wale_N\n"); }

TEST(Csv, IsWrittenWholeOrNotAtAll) {
  const std::string path = ::testing::TempDir() + "csv_test.csv";
  write_csv(testing::made_results(), path);
  EXPECT_EQ(read_file(path), curve_csv(testing::made_results()));
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::filesystem::remove(path);
  EXPECT_THROW(write_csv({}, ::testing::TempDir() + "no/such/folder.csv"), std::system_error);
  if (std::filesystem::exists("/dev/full")) {
    std::filesystem::remove(path + ".part");
    std::filesystem::create_symlink("/dev/full", path + ".part");
    EXPECT_THROW(write_csv(testing::made_results(), path), std::system_error);
    EXPECT_FALSE(std::filesystem::exists(path));
  }
}

}  // namespace
}  // namespace wale
