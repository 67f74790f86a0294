#include "core/robot/kinematics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <random>

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_wdls.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace mirrorarm::robot {
namespace {

constexpr double kReached_m = 1e-4, kReached_rad = 1e-4;
constexpr double kNewtonEpsilon = 5e-5;  // per component, so that the norms stay below what is promised
constexpr int kNewtonSteps = 60;
constexpr double kDamping = 0.01;
constexpr std::array kSeedSpread_rad = {0.0, 0.1, 0.2, 0.4, 0.8};

KDL::Frame toKdl(const RigidTransform& X) {
  const Eigen::Matrix3d R = X.linear();
  const Eigen::Vector3d p = X.translation();
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          KDL::Vector(p.x(), p.y(), p.z())};
}

RigidTransform toEigen(const KDL::Frame& frame) {
  return makeTransform(
      Eigen::Matrix3d(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data)),
      Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(frame.p.data)));
}

KDL::Segment segmentOf(const JointDescription& joint) {
  const KDL::Frame X_parent = toKdl(joint.X_parent);
  const KDL::Vector axis(joint.axis.x(), joint.axis.y(), joint.axis.z());
  return KDL::Segment(joint.name, KDL::Joint(joint.name, X_parent.p, X_parent.M * axis, KDL::Joint::RotAxis),
                      X_parent);
}

/// One segment a joint, the flange as a fixed one at the end.
KDL::Chain chainOf(const ArmDescription& arm) {
  KDL::Chain chain;
  for (const auto& joint : arm.joints) chain.addSegment(segmentOf(joint));
  chain.addSegment(KDL::Segment("flange", KDL::Joint(KDL::Joint::None), toKdl(arm.X_last_F)));
  return chain;
}

KDL::JntArray toKdl(const Joints& joints) {
  KDL::JntArray all(static_cast<unsigned>(joints.size()));
  all.data = joints;
  return all;
}

}  // namespace

struct Kinematics::Body {
  explicit Body(const ArmDescription& arm)
      : chain(chainOf(arm)),
        ranges(jointRanges(arm)),
        lower(toKdl(ranges.lower)),
        upper(toKdl(ranges.upper)),
        position(chain),
        jacobian(chain),
        velocity(chain),
        newton(chain, lower, upper, position, velocity, kNewtonSteps, kNewtonEpsilon),
        q(chain.getNrOfJoints()),
        seed(chain.getNrOfJoints()),
        solution(chain.getNrOfJoints()),
        J(chain.getNrOfJoints()) {
    if (const auto srs = srsArm(arm)) closed_form.emplace(*srs, ranges);
    velocity.setLambda(kDamping);
  }

  [[nodiscard]] RigidTransform frameAfter(const Joints& joints, int segments) {
    assert(joints.size() == q.data.size());
    q.data = joints;
    KDL::Frame frame;
    position.JntToCart(q, frame, segments);
    return toEigen(frame);
  }

  /// Newton clamps to the limits and may stick there, so the answer is checked, not believed.
  [[nodiscard]] bool newtonFinds(const RigidTransform& X_BF) {
    if (newton.CartToJnt(seed, toKdl(X_BF), solution) < 0 || !solution.data.allFinite()) return false;
    const RigidTransform X_found = frameAfter(solution.data, allSegments());
    return (X_found.translation() - X_BF.translation()).norm() <= kReached_m &&
           angleBetween(X_found, X_BF) <= kReached_rad && ranges.have(solution.data);
  }

  [[nodiscard]] Expected<Joints, NoPosture> approached(const RigidTransform& X_BF, const Joints& near) {
    if (!isRigid(X_BF) || !near.allFinite()) return unexpected(NoPosture::kOutOfReach);
    std::minstd_rand random(1);  // the same question finds the same answer
    for (const double spread : kSeedSpread_rad) {
      std::uniform_real_distribution<double> nearby(-spread, spread);
      for (Eigen::Index i = 0; i < near.size(); ++i)
        seed.data[i] = std::clamp(near[i] + nearby(random), ranges.lower[i], ranges.upper[i]);
      if (newtonFinds(X_BF)) return Joints(solution.data);
    }
    return unexpected(NoPosture::kOutOfReach);
  }

  [[nodiscard]] int allSegments() const { return static_cast<int>(chain.getNrOfSegments()); }

  std::optional<PostureChoice> closed_form;
  KDL::Chain chain;  // the solvers below keep references to it
  JointRanges ranges;
  KDL::JntArray lower, upper;
  KDL::ChainFkSolverPos_recursive position;
  KDL::ChainJntToJacSolver jacobian;
  KDL::ChainIkSolverVel_wdls velocity;
  KDL::ChainIkSolverPos_NR_JL newton;
  KDL::JntArray q, seed, solution;
  KDL::Jacobian J;
};

Kinematics::Kinematics(const ArmDescription& arm) : body_(std::make_unique<Body>(arm)) {
  assert(arm.jointCount() > 0 && arm.jointCount() <= kMaxJoints);
}
Kinematics::~Kinematics() = default;
Kinematics::Kinematics(Kinematics&&) noexcept = default;
Kinematics& Kinematics::operator=(Kinematics&&) noexcept = default;

int Kinematics::jointCount() const { return static_cast<int>(body_->chain.getNrOfJoints()); }

RigidTransform Kinematics::flange(const Joints& q) const {
  return body_->frameAfter(q, body_->allSegments());
}

RigidTransform Kinematics::link(const Joints& q, int link) const {
  assert(link >= 0 && link <= jointCount());
  return body_->frameAfter(q, link);
}

Jacobian Kinematics::jacobian(const Joints& q) const {
  assert(q.size() == jointCount());
  body_->q.data = q;
  body_->jacobian.JntToJac(body_->q, body_->J);
  return body_->J.data;
}

Expected<Joints, NoPosture> Kinematics::follow(const RigidTransform& X_BF, const Joints& seed) const {
  if (body_->closed_form) return body_->closed_form->nearest(X_BF, seed);
  return body_->approached(X_BF, seed);
}

Expected<Joints, NoPosture> Kinematics::reach(const RigidTransform& X_BF, const Joints& seed) const {
  if (body_->closed_form) return body_->closed_form->any(X_BF, seed);
  return body_->approached(X_BF, seed);
}

std::optional<Joints> Kinematics::inverse(const RigidTransform& X_BF, const Joints& seed) const {
  const auto q = follow(X_BF, seed);
  if (!q) return std::nullopt;
  return *q;
}

}  // namespace mirrorarm::robot
