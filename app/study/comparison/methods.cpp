// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/methods.h"

#include <optional>
#include <utility>

#include "haptics/proxy/proxy.h"
#include "haptics/proxy/tick.h"

namespace comparison {
namespace {

class Ours final : public Method {
 public:
  Ours(std::shared_ptr<const haptics::Scene> scene, double isovalue, Limit limit, double stiffness)
      : scene_{std::move(scene)}, isovalue_{isovalue}, limit_{limit}, coupling_{stiffness, 0.0} {}

  const char* name() const override { return "ours"; }
  bool subSteps() const override { return true; }
  void start(const Pose& X_WP) override {
    proxy_ = std::make_unique<haptics::Proxy>(*scene_, X_WP);
  }

 private:
  void step(const Pose& X_WD, Tick& tick) override {
    haptics::Budget budget = limit_.work > 0 ? haptics::Budget::counted(limit_.work)
                                             : haptics::Budget::timed(limit_.nanoseconds);
    const haptics::TickResult result =
        haptics::tick(*scene_, isovalue_, coupling_, X_WD, *proxy_, budget, limit_.rate.period());
    tick.X_WP = proxy_->X_WP;
    tick.force = result.wrench_W.force;
    tick.torque = result.wrench_W.torque;
    tick.contacts = result.contacts;
    tick.counts = budget.counts;
    tick.work = budget.spent();
    tick.cut = result.cut;
  }

  std::shared_ptr<const haptics::Scene> scene_;
  double isovalue_;
  Limit limit_;
  haptics::VirtualCoupling coupling_;
  std::unique_ptr<haptics::Proxy> proxy_;
};

/// What was looked up since it was made.
class Counted {
 public:
  explicit Counted(const reference::Solid& solid)
      : solid_{solid}, samples_{solid.samples()}, gradients_{solid.gradients()} {}
  haptics::Counts since(std::int64_t pivots, int sub_steps) const {
    return {solid_.samples() - samples_, solid_.gradients() - gradients_, pivots, sub_steps};
  }

 private:
  const reference::Solid& solid_;
  std::int64_t samples_, gradients_;
};

class Rival final : public Method {
 public:
  Rival(const Touched& scene, const haptics::PointShell& shell, const reference::Choices& choices,
        int sub_steps)
      : scene_{{*scene.volume, scene.isovalue, choices}, shell, kStiffness, 0.0},
        sub_steps_{sub_steps} {}

  const char* name() const override {
    switch (scene_.solid.choices().variant) {
      case reference::Variant::Literal:
        return "literal";
      case reference::Variant::Charitable:
        return "charitable";
      case reference::Variant::AcceptInside:
        break;
    }
    return "accept-inside";
  }
  bool subSteps() const override { return sub_steps_ > 1; }
  void start(const Pose& X_WP) override {
    state_ = {};
    state_.X_WP = X_WP;
  }

 private:
  void step(const Pose& X_WD, Tick& tick) override {
    const Counted counted{scene_.solid};
    const std::int64_t pivots = state_.pivots;
    Wrench wrench;
    for (int n = 0; n < sub_steps_; ++n) wrench = reference::tick(scene_, X_WD, state_);
    tick.force = wrench.force;
    tick.torque = wrench.torque;
    tick.X_WP = state_.X_WP;
    tick.contacts = static_cast<int>(state_.contacts.size());
    tick.counts = counted.since(state_.pivots - pivots, sub_steps_);
  }

  reference::Scene scene_;
  int sub_steps_;
  reference::State state_;
};

/// The scene as a rival of others knows it: its field has no choices to make.
reference::Scene toldOf(const Touched& scene, const haptics::PointShell& shell, double stiffness) {
  return {{*scene.volume, scene.isovalue, {}}, shell, stiffness, 0.0};
}

class Penalty final : public Method {
 public:
  Penalty(const Touched& scene, const haptics::PointShell& shell,
          const rivals::PenaltySettings& settings, haptics::ServoRate rate, double stiffness)
      : scene_{toldOf(scene, shell, stiffness)}, settings_{settings}, rate_{rate} {}

  const char* name() const override { return "penalty"; }
  bool subSteps() const override { return settings_.sub_steps > 1; }
  void start(const Pose& X_WP) override {
    state_ = {};
    state_.X_WP = X_WP;
  }

 private:
  void step(const Pose& X_WD, Tick& tick) override {
    const Counted counted{scene_.solid};
    const Wrench wrench = rivals::penaltyTick(scene_, settings_, rate_.period(), X_WD, state_);
    tick.force = wrench.force;
    tick.torque = wrench.torque;
    tick.X_WP = state_.X_WP;
    tick.contacts = static_cast<int>(state_.touching.size());
    tick.lags = true;
    tick.counts = counted.since(0, settings_.sub_steps);
  }

  reference::Scene scene_;
  rivals::PenaltySettings settings_;
  haptics::ServoRate rate_;
  rivals::PenaltyState state_;
};

class GodObject final : public Method {
 public:
  GodObject(const Touched& scene, const haptics::PointShell& shell,
            const rivals::GodObjectSettings& settings, double stiffness)
      : scene_{toldOf(scene, shell, stiffness)}, settings_{settings} {}

  const char* name() const override { return "god object"; }
  bool subSteps() const override { return settings_.sub_steps > 1; }
  void start(const Pose& X_WP) override {
    state_ = {};
    state_.X_WP = X_WP;
  }

 private:
  void step(const Pose& X_WD, Tick& tick) override {
    const Counted counted{scene_.solid};
    const std::int64_t pivots = state_.pivots;
    const Wrench wrench = rivals::godObjectTick(scene_, settings_, X_WD, state_);
    tick.force = wrench.force;
    tick.torque = wrench.torque;
    tick.X_WP = state_.X_WP;
    tick.contacts = state_.contacts;
    tick.counts = counted.since(state_.pivots - pivots, state_.sub_steps);
  }

  reference::Scene scene_;
  rivals::GodObjectSettings settings_;
  rivals::GodObjectState state_;
};

}  // namespace

Tick Method::tick(const Pose& X_WD) {
  Tick tick;
  const std::int64_t begun = haptics::Budget::threadTime();
  step(X_WD, tick);
  tick.cpu_ns = haptics::Budget::threadTime() - begun;
  return tick;
}

std::unique_ptr<Method> ours(std::shared_ptr<const haptics::Scene> scene, double isovalue,
                             Limit limit, double stiffness) {
  return std::make_unique<Ours>(std::move(scene), isovalue, limit, stiffness);
}

std::unique_ptr<Method> rival(const Touched& scene, const haptics::PointShell& shell,
                              const reference::Choices& choices, int sub_steps) {
  return std::make_unique<Rival>(scene, shell, choices, sub_steps);
}

std::unique_ptr<Method> penalty(const Touched& scene, const haptics::PointShell& shell,
                                const rivals::PenaltySettings& settings, haptics::ServoRate rate,
                                double stiffness) {
  return std::make_unique<Penalty>(scene, shell, settings, rate, stiffness);
}

std::unique_ptr<Method> godObject(const Touched& scene, const haptics::PointShell& shell,
                                  const rivals::GodObjectSettings& settings, double stiffness) {
  return std::make_unique<GodObject>(scene, shell, settings, stiffness);
}

std::vector<std::unique_ptr<Method>> allMethods(const Touched& scene,
                                                std::shared_ptr<const haptics::Scene> built,
                                                Limit limit) {
  const haptics::PointShell& shell = built->tool.shell;
  std::vector<std::unique_ptr<Method>> all;
  for (const auto variant : {reference::Variant::Literal, reference::Variant::Charitable,
                             reference::Variant::AcceptInside})
    all.push_back(rival(scene, shell, reference::choicesFor(scene.volume->grid, variant)));
  all.push_back(penalty(scene, shell));
  all.push_back(godObject(scene, shell));
  all.push_back(ours(std::move(built), scene.isovalue, limit));
  return all;
}

}  // namespace comparison
