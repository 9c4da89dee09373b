// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/device_model.h"

#include <cmath>

namespace haptics {
namespace {

Vec3 stepped(const Vec3& v, double step) HAPTICS_RT {
  return step > 0.0 ? Vec3{(v / step).array().round() * step} : v;
}

DeviceModel modelOf(const DeviceRating& rating) {
  DeviceModel model{.name = std::string{rating.id}, .rating = rating};
  model.mass = rating.force <= 5.0 ? 0.1 : rating.force <= 15.0 ? 0.2 : 0.3;
  model.linkage.encoder = rating.resolution;
  model.linkage.angle_encoder = 0.5e-3;
  model.linkage.torque = rating.torque > 0.0;
  return model;
}

}  // namespace

Pose Linkage::read(const Pose& X_WH) const HAPTICS_RT {
  Pose X_WD = X_WH;
  X_WD.translation() = stepped(X_WH.translation(), encoder);
  if (angle_encoder > 0.0) {
    const Eigen::AngleAxisd turn{X_WH.linear()};
    const Vec3 read = stepped(turn.angle() * turn.axis(), angle_encoder);
    const double angle = read.norm();
    X_WD.linear() = angle > 0.0 ? Eigen::AngleAxisd{angle, read / angle}.toRotationMatrix()
                                : Mat3::Identity().eval();
  }
  X_WD.translation() += X_WD.linear() * arm;
  return X_WD;
}

Pose Linkage::handleAt(const Pose& X_WD) const HAPTICS_RT {
  Pose X_WH = X_WD;
  X_WH.translation() -= X_WD.linear() * arm;
  return X_WH;
}

Wrench Linkage::late(const Wrench& sent) HAPTICS_RT {
  constexpr int kPlaces = kLongestDelay + 1;
  under_way_[next_] = sent;
  const int whole = int(delay);
  const double share = delay - whole;
  const auto ago = [&](int ticks) { return under_way_[(next_ + kPlaces - ticks) % kPlaces]; };
  Wrench arriving = ago(whole);
  if (share > 0.0) {
    const Wrench before = ago(whole + 1);
    arriving.force += share * (before.force - arriving.force);
    arriving.torque += share * (before.torque - arriving.torque);
  }
  next_ = (next_ + 1) % kPlaces;
  return arriving;
}

Wrench Linkage::carry(const Wrench& sent_W, const Pose& X_WH) HAPTICS_RT {
  Wrench arriving = late(sent_W);
  if (torque)
    arriving.torque += (X_WH.linear() * arm).cross(arriving.force);
  else
    arriving.torque.setZero();
  return arriving;
}

Grip DeviceModel::heldBy(const HumanHand& hand, double gyration) const {
  Grip grip;
  grip.mass = mass + hand.mass;
  grip.damping = damping + hand.damping;
  grip.stiffness = hand.stiffness;
  grip.gyration = gyration;
  grip.coulomb = coulomb;
  return grip;
}

std::vector<DeviceModel> deviceModels() {
  std::vector<DeviceModel> models;
  for (const DeviceRating& rating : deviceRatings())
    if (rating.actuated > 0) models.push_back(modelOf(rating));
  DeviceModel arm = modelOf(*findRating("omni"));
  arm.name = "omni-arm-200";
  arm.linkage.arm = {0.0, 0.0, -0.2};
  models.push_back(std::move(arm));
  return models;
}

std::optional<DeviceModel> findDeviceModel(std::string_view name) {
  for (DeviceModel& model : deviceModels())
    if (model.name == name) return std::move(model);
  return {};
}

}  // namespace haptics
