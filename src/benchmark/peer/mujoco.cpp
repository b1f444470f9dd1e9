// MuJoCo on the library's work: a Maxwell element's dashpot is an actuator whose activation follows its control with
// the relaxation time.
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {
namespace {

// Numbers that the control is made of, in the user data of the simulation.
enum UserData { kStart, kDisplacement, kVelocity, kUserDataSize };

// One mass, as MuJoCo knows no system without, which the actuators leave alone: their gain is 0.
std::string modelOf(const PeerWork& work) {
  std::string text =
      "<mujoco><option integrator='RK4' gravity='0 0 0'>"
      "<flag constraint='disable' contact='disable'/></option><size nuserdata='" +
      std::to_string(kUserDataSize) +
      "'/><worldbody><body><joint name='axis' type='slide'/>"
      "<geom type='sphere' size='0.1' mass='1'/></body></worldbody><actuator>";
  for (const double rate : work.rate) {
    char relaxation_time[32];
    std::snprintf(relaxation_time, sizeof relaxation_time, "%.17g", 1.0 / rate);
    text += "<general joint='axis' dyntype='filter' dynprm='" + std::string(relaxation_time) + "' gainprm='0'/>";
  }
  return text + "</actuator></mujoco>";
}

using Model = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using Data = std::unique_ptr<mjData, void (*)(mjData*)>;

Model load(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("rubber_suspension_peer_" + std::to_string(getpid()) + ".xml");
  std::ofstream(file) << text;
  char error[200] = "";
  Model model(mj_loadXML(file.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  std::filesystem::remove(file);
  if (model == nullptr) {
    throw std::runtime_error(std::string("MuJoCo refuses the model: ") + error);
  }
  return model;
}

// The displacement at the time of a stage of the method.
void follow(const mjModel* model, mjData* data) {
  const double displacement =
      data->userdata[kDisplacement] + data->userdata[kVelocity] * (data->time - data->userdata[kStart]);
  std::fill_n(data->ctrl, model->nu, displacement);
}

}  // namespace

void mujocoRungeKutta4(const PeerWork& work, int substeps, std::vector<double>& force) {
  const Model model = load(modelOf(work));
  model->opt.timestep = work.dt / substeps;
  const Data data(mj_makeData(model.get()), mj_deleteData);
  std::fill_n(data->act, model->na, work.displacement[0]);
  mjcb_control = follow;
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    data->userdata[kStart] = data->time;
    data->userdata[kDisplacement] = work.displacement[i - 1];
    data->userdata[kVelocity] = work.velocity(i);
    for (int step = 0; step < substeps; ++step) {
      mj_step(model.get(), data.get());
    }
    force[i] = forceOfDashpots(work, work.displacement[i], data->act);
  }
  mjcb_control = nullptr;
}

}  // namespace rubber_suspension::benchmark
