#include <fstream>
#include <iterator>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "core/vision/centres_file.h"

namespace mirrorarm::vision {
namespace {

TEST(CentresFile, HasTheColumnsOfTheFormat) {
  const auto file =
      std::filesystem::temp_directory_path() / ("centres" + std::to_string(::getpid()) + ".csv");
  DetectedMarker marker;
  marker.centre_px = {12.25, 7.5};
  marker.covariance_px2 << 1e-4, 2e-5, 2e-5, 3e-4;
  marker.ellipse = {{12.25, 7.5}, 5.0, 4.0, 0.3};
  marker.outline_fraction = 1.0;
  ASSERT_TRUE(writeCentres(file, std::vector<CentreRow>{{4, "left", marker}}));
  const auto table = CsvTable::read(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(table);
  const std::vector<std::string> wanted{"index",           "camera",  "x_px",     "y_px",     "sxx_px2",
                                        "sxy_px2",         "syy_px2", "major_px", "minor_px", "angle_rad",
                                        "outline_fraction"};
  ASSERT_TRUE(std::equal(wanted.begin(), wanted.end(), table->header().begin(), table->header().end()));
  ASSERT_EQ(table->rows().size(), 1U);
  EXPECT_EQ(*table->number(table->rows()[0], 7), 10.0);
  EXPECT_EQ(*table->number(table->rows()[0], 5), 2e-5);
}

TEST(CentresFile, SaysWhenItCannotBeWritten) { EXPECT_FALSE(writeCentres("/proc/centres.csv", {})); }

}  // namespace
}  // namespace mirrorarm::vision
