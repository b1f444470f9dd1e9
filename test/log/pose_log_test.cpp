// Logs of six directions: columns, units, refusals.
#include "rubber_suspension/log/pose_log.h"

#include <unistd.h>

#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

class PoseLogTest : public testing::Test {
 protected:
  std::string write(const std::string& text) {
    std::ofstream(path_) << text;
    return path_;
  }

  std::string refusal(const std::string& text) {
    return messageOf<log::LogError>([&] { log::readPoseLog(write(text)); });
  }

  ~PoseLogTest() override { unlink(path_.c_str()); }

  std::string path_ = testing::TempDir() + "pose_log_" + std::to_string(getpid()) + ".csv";
};

TEST_F(PoseLogTest, ReadsPosesAndWrenchesInTheirUnits) {
  const log::PoseLog log =
      log::readPoseLog(write("time_s,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg,Fx_N,Fy_kN,Fz_N,Mx_Nm,My_kNm,Mz_Nm,note_V\n"
                             "0,1,2,3,180,0,90,10,0.5,30,40,0.25,60,1\n0.001,1,2,3,0,0,-90,10,20,30,40,50,60,1\n"));
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log.stamp[1], 1000000);
  EXPECT_EQ(log.coordinate[1][0], 0.002);
  EXPECT_NEAR(log.coordinate[3][0], element::kPi, 1e-15);
  EXPECT_NEAR(log.coordinate[5][1], -element::kPi / 2, 1e-15);
  EXPECT_EQ(log.wrench[1][0], 500.0);
  EXPECT_EQ(log.wrench[4][0], 250.0);
  EXPECT_EQ(log.wrench[5][1], 60.0);
}

TEST_F(PoseLogTest, ReadsPosesAlone) {
  const log::PoseLog log = log::readPoseLog(
      write("time [s];x [mm];y [mm];z [mm];rx [rad];ry [rad];rz [rad]\n0;1,5;2;3;0,1;0;0\n0,002;1;2;3;0;0;0\n"));
  EXPECT_EQ(log.coordinate[0][0], 0.0015);
  EXPECT_EQ(log.coordinate[3][0], 0.1);
  EXPECT_TRUE(log.wrench[0].empty());
}

TEST_F(PoseLogTest, ReadsBackWhatItWrites) {
  log::PoseLog log =
      log::readPoseLog(write("time_s,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n0,1,2,3,4,5,6\n0.1,1,1,1,1,1,1\n"));
  log.wrench.fill({1.0 / 3.0, -1e-17});
  log::writeWrenchCsv(path_, log, log.wrench);
  const log::PoseLog again = log::readPoseLog(path_);
  EXPECT_EQ(again.coordinate, log.coordinate);
  EXPECT_EQ(again.wrench, log.wrench);
  EXPECT_EQ(again.stamp, log.stamp);
}

TEST_F(PoseLogTest, RefusesWhatIsNoPose) {
  for (const auto& [columns, word] : {std::pair("leg1_mm,leg2_mm,leg3_mm,leg4_mm,leg5_mm,leg6_mm", "hexapod"),
                                      {"x_mm,y_mm,z_mm,rx_deg,ry_deg", "'rz'"},
                                      {"x_mm,y_mm,z_mm,rx_mm,ry_deg,rz_deg", "rx_mm"},
                                      {"x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg,Fx_N", "'Fy'"},
                                      {"x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg,Fz_N", "a force, but no column 'Fx'"}}) {
    std::string row;
    for (std::string::size_type i = 0, count = 1 + std::count(columns, columns + std::strlen(columns), ','); i < count;
         ++i) {
      row += ",1";
    }
    EXPECT_THAT(refusal(std::string("time_s,") + columns + "\n0" + row + "\n1" + row + "\n"), testing::HasSubstr(word));
  }
}

}  // namespace
}  // namespace rubber_suspension
