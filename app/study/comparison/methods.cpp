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
  Ours(std::shared_ptr<const haptics::Scene> scene, double isovalue, Limit limit)
      : scene_{std::move(scene)}, isovalue_{isovalue}, limit_{limit} {}

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
    tick.contacts = result.contacts;
    tick.counts = budget.counts;
    tick.work = budget.spent();
    tick.cut = result.cut;
  }

  std::shared_ptr<const haptics::Scene> scene_;
  double isovalue_;
  Limit limit_;
  haptics::VirtualCoupling coupling_{kStiffness, 0.0};
  std::unique_ptr<haptics::Proxy> proxy_;
};

class Rival final : public Method {
 public:
  Rival(const Touched& scene, const haptics::PointShell& shell, const reference::Choices& choices)
      : scene_{{*scene.volume, scene.isovalue, choices}, shell, kStiffness, 0.0} {}

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
  void start(const Pose& X_WP) override {
    state_ = {};
    state_.X_WP = X_WP;
  }

 private:
  void step(const Pose& X_WD, Tick& tick) override {
    const std::int64_t samples = scene_.solid.samples(), gradients = scene_.solid.gradients(),
                       pivots = state_.pivots;
    tick.force = reference::tick(scene_, X_WD, state_).force;
    tick.X_WP = state_.X_WP;
    tick.contacts = static_cast<int>(state_.contacts.size());
    tick.counts = {scene_.solid.samples() - samples, scene_.solid.gradients() - gradients,
                   state_.pivots - pivots, 1};
  }

  reference::Scene scene_;
  reference::State state_;
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
                             Limit limit) {
  return std::make_unique<Ours>(std::move(scene), isovalue, limit);
}

std::unique_ptr<Method> rival(const Touched& scene, const haptics::PointShell& shell,
                              const reference::Choices& choices) {
  return std::make_unique<Rival>(scene, shell, choices);
}

std::vector<std::unique_ptr<Method>> allMethods(const Touched& scene,
                                                std::shared_ptr<const haptics::Scene> built,
                                                Limit limit) {
  const haptics::PointShell& shell = built->tool.shell;
  std::vector<std::unique_ptr<Method>> all;
  for (const auto variant : {reference::Variant::Literal, reference::Variant::Charitable,
                             reference::Variant::AcceptInside})
    all.push_back(rival(scene, shell, reference::choicesFor(scene.volume->grid, variant)));
  all.push_back(ours(std::move(built), scene.isovalue, limit));
  return all;
}

}  // namespace comparison
