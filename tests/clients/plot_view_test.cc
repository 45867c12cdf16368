#include "clients/cpp/plot_view.h"

#include <gtest/gtest.h>

namespace dualarm {
namespace {

TEST(PlotView, HoldsAllLinesWithAMarginAtRoundNumbers) {
  const PlotView view =
      plot_view({{{12.0, 31.0}, {48.0, 40.0}}, {{20.0, 66.0}}}, {{-180.0, 180.0}, {-180.0, 180.0}}, 10.0);
  EXPECT_EQ(view.x.min, 0.0);
  EXPECT_EQ(view.x.max, 60.0);
  EXPECT_EQ(view.y.min, 20.0);
  EXPECT_EQ(view.y.max, 80.0);
}

TEST(PlotView, EndsAtTheLimits) {
  const PlotView view = plot_view({{{0.0, 0.0}, {48.0, 88.0}}}, {{0.0, 180.0}, {-1.0, 90.0}}, 10.0);
  EXPECT_EQ(view.x.min, 0.0);
  EXPECT_EQ(view.y.min, -1.0);
  EXPECT_EQ(view.y.max, 90.0);
}

TEST(PlotView, OfNothingIsTheLimits) {
  const PlotView view = plot_view({{}}, {{0.0, 180.0}, {-1.0, 90.0}}, 10.0);
  EXPECT_EQ(view.x.max, 180.0);
  EXPECT_EQ(view.y.min, -1.0);
}

}  // namespace
}  // namespace dualarm
