#include "benchmarks/robot/kdl_lma.h"

#include <cmath>
#include <numbers>

#include <kdl/chain.hpp>
#include <kdl/chainiksolverpos_lma.hpp>

namespace mirrorarm::benchmarks::robot {
namespace {

using mirrorarm::robot::ArmDescription;
using mirrorarm::robot::Joints;

KDL::Frame toKdl(const RigidTransform& X) {
  const Eigen::Matrix3d R = X.linear();
  const Eigen::Vector3d p = X.translation();
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          KDL::Vector(p.x(), p.y(), p.z())};
}

KDL::Chain chainOf(const ArmDescription& arm) {
  KDL::Chain chain;
  for (const auto& joint : arm.joints) {
    const KDL::Frame X = toKdl(joint.X_parent);
    const KDL::Vector axis(joint.axis.x(), joint.axis.y(), joint.axis.z());
    chain.addSegment(
        KDL::Segment(joint.name, KDL::Joint(joint.name, X.p, X.M * axis, KDL::Joint::RotAxis), X));
  }
  chain.addSegment(KDL::Segment("flange", KDL::Joint(KDL::Joint::None), toKdl(arm.X_last_F)));
  return chain;
}

}  // namespace

struct KdlLma::Body {
  explicit Body(const ArmDescription& arm)
      : chain(chainOf(arm)), solver(chain), seed(chain.getNrOfJoints()), answer(chain.getNrOfJoints()) {}
  KDL::Chain chain;
  KDL::ChainIkSolverPos_LMA solver;
  KDL::JntArray seed, answer;
};

KdlLma::KdlLma(const ArmDescription& arm) : body_(std::make_unique<Body>(arm)) {}
KdlLma::~KdlLma() = default;

std::optional<Joints> KdlLma::solve(const RigidTransform& X_BF, const Joints& seed) {
  body_->seed.data = seed;
  if (body_->solver.CartToJnt(body_->seed, toKdl(X_BF), body_->answer) < 0) return std::nullopt;
  Joints q = body_->answer.data;
  for (double& angle : q) angle = std::remainder(angle, 2.0 * std::numbers::pi);
  return q;
}

}  // namespace mirrorarm::benchmarks::robot
