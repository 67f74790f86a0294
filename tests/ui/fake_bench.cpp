#include "tests/ui/fake_bench.h"

#include <algorithm>
#include <stdexcept>

#include "core/camera/rig_file.h"
#include "core/robot/kinematics.h"
#include "core/robot/motion_limits.h"
#include "core/robot/urdf.h"

namespace mirrorarm::ui::test {
namespace {

const Eigen::Vector3d kTargetInCamera(0.06, 0.0, 0.40);

/// Ten places on the half of a forearm that looks to the cameras.
std::vector<Eigen::Vector3d> sleeve() {
  std::vector<Eigen::Vector3d> markers;
  for (int i = 0; i < 10; ++i) {
    const double angle = (i % 3 - 1) * 0.7 + 0.1 * (i % 4);
    markers.emplace_back(-0.1 + 0.022 * i, 0.045 * std::sin(angle), 0.045 * (0.9 - std::cos(angle)));
  }
  return markers;
}

robot::Joints restingJoints() {
  robot::Joints q(7);
  q << 0.0, -0.482, 0.0, 1.449, 0.0, -1.211, 0.0;
  return q;
}

RigidTransform cameraOnFlange() {
  Eigen::Matrix3d R;
  R << -1.0, 0.0, 0.0, 0.0, -0.259, 0.966, 0.0, 0.966, 0.259;
  return makeTransform(Eigen::Quaterniond(R), {0.06, 0.08, 0.03});
}

vision::DetectedMarker detected(const Eigen::Vector2d& pixel) {
  vision::DetectedMarker marker;
  marker.centre_px = pixel;
  marker.ellipse = {pixel, 6.0, 5.0, 0.3};
  return marker;
}

/// A dark image with a bright square at every marker.
camera::GreyImage picture(const camera::Intrinsics& camera,
                          const std::vector<vision::DetectedMarker>& markers) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(camera.width_px) * camera.height_px, 14);
  for (const auto& marker : markers)
    for (int dy = -5; dy <= 5; ++dy)
      for (int dx = -5; dx <= 5; ++dx) {
        const int x = std::clamp(static_cast<int>(marker.centre_px.x()) + dx, 0, camera.width_px - 1);
        const int y = std::clamp(static_cast<int>(marker.centre_px.y()) + dy, 0, camera.height_px - 1);
        pixels[static_cast<std::size_t>(y) * camera.width_px + x] = 230;
      }
  return {camera.width_px, camera.height_px, std::move(pixels)};
}

void see(const camera::StereoRig& rig, const std::vector<Eigen::Vector3d>& points_C,
         station::TrackedFrame& frame) {
  for (const auto& p_C : points_C) {
    const auto left = rig.left.project(p_C);
    const auto right = rig.right.project(rig.X_RC * p_C);
    if (!left || !right) continue;
    vision::StereoPoint point;
    point.p_C = p_C;
    point.left = point.right = static_cast<int>(frame.observation.points.size());
    frame.observation.points.push_back(point);
    frame.observation.left.markers.push_back(detected(*left));
    frame.observation.right.markers.push_back(detected(*right));
  }
  frame.frame.left = picture(rig.left.intrinsics(), frame.observation.left.markers);
  frame.frame.right = picture(rig.right.intrinsics(), frame.observation.right.markers);
  frame.vision_ms = 8.4;
}

struct Reflection {
  double x_px, y_px, width_px, height_px;
  vision::Rejection reason;
};

const std::vector<Reflection> kReflections{
    {820, 300, 120, 8, vision::Rejection::kTooElongated}, {480, 620, 90, 90, vision::Rejection::kTooLarge},
    {900, 590, 22, 14, vision::Rejection::kNotAnEllipse}, {1288, 480, 16, 16, vision::Rejection::kAtBorder},
    {700, 610, 10, 12, vision::Rejection::kSaturated},    {860, 470, 12, 5, vision::Rejection::kCut},
    {610, 360, 1, 1, vision::Rejection::kTooSmall},       {940, 420, 2, 1, vision::Rejection::kTooSmall}};

using Pixels = std::vector<std::uint8_t>;

void paint(Pixels& pixels, const camera::GreyImage& image, const Reflection& light, std::uint8_t level) {
  const auto from = [](double middle, double side) { return static_cast<int>(middle - side / 2); };
  for (int y = from(light.y_px, light.height_px); y < light.y_px + light.height_px / 2; ++y)
    for (int x = from(light.x_px, light.width_px); x < light.x_px + light.width_px / 2; ++x)
      if (x >= 0 && y >= 0 && x < image.width() && y < image.height())
        pixels[static_cast<std::size_t>(y) * image.width() + x] = level;
}

/// Reflections painted in and refused, the marker covered to its right.
void clutterImage(camera::GreyImage& image, vision::Detection& detection, std::size_t covered) {
  const auto view = image.view();
  Pixels pixels(view.data, view.data + static_cast<std::ptrdiff_t>(view.width_px) * view.height_px);
  for (const auto& light : kReflections) {
    paint(pixels, image, light, 120);
    ++detection.rejected[static_cast<std::size_t>(light.reason)];
    detection.rejected_lights.push_back(
        {{light.x_px, light.y_px}, std::max(light.width_px, light.height_px), light.reason});
  }
  auto& cut = detection.markers[covered];
  cut.cut = true;
  paint(pixels, image, {cut.centre_px.x() + 5, cut.centre_px.y(), 7, 12, {}}, 14);
  for (std::size_t i = 0; i < detection.markers.size(); ++i)
    paint(pixels, image, {detection.markers[i].centre_px.x(), detection.markers[i].centre_px.y(), 3, 3, {}},
          250);
  image = {image.width(), image.height(), std::move(pixels)};
}

/// A disc of the left image that two of the right one may be.
void addRivals(const camera::StereoRig& rig, vision::StereoObservation& seen) {
  seen.left.markers.push_back(detected(rig.left.project({0.0, 0.07, 0.40}).value()));
  for (const double depth_m : {0.40, 0.46}) {
    const Eigen::Vector3d p_C = Eigen::Vector3d(0.0, 0.175, 1.0) * depth_m;
    seen.right.markers.push_back(detected(rig.right.project(rig.X_RC * p_C).value()));
    vision::StereoPoint point;
    point.p_C = p_C;
    point.left = static_cast<int>(seen.left.markers.size()) - 1;
    point.right = static_cast<int>(seen.right.markers.size()) - 1;
    point.rivals = 1;
    point.preferred = depth_m < 0.43;
    seen.points.push_back(point);
  }
}

tracking::TrackedTarget tracked(int markers) {
  tracking::TrackedTarget target;
  target.status = tracking::TrackStatus::kTracked;
  target.reason = tracking::LostReason::kNone;
  target.X_CT.translation() = kTargetInCamera;
  target.rms_m = 0.00012;
  target.marker_count = target.matched_count = markers;
  for (int i = 0; i < markers; ++i)
    target.point_of_marker[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(i);
  return target;
}

}  // namespace

Workplace benchWorkplace() {
  const std::filesystem::path resources = RESOURCES;
  auto arm = robot::readUrdf(resources / "robots/lbr4plus.urdf");
  auto rig = camera::readRig(resources / "rigs/pinhole.yaml");
  if (!arm || !rig) throw std::runtime_error("the bench's own files cannot be read");
  Workplace workplace;
  workplace.limits = robot::limitsOf("therapy", *arm).value();
  workplace.arm = std::move(*arm);
  workplace.rig = std::move(*rig);
  workplace.X_FC = cameraOnFlange();
  workplace.X_FE.translation().z() = 0.135;
  workplace.simulated = true;
  return workplace;
}

FakeStation::FakeStation(const Workplace& workplace)
    : rig_(workplace.rig), frame_(std::make_shared<station::TrackedFrame>()) {
  tracking::Target target;
  target.name = "forearm";
  target.markers_T = sleeve();
  std::vector<Eigen::Vector3d> points_C;
  for (const auto& marker : target.markers_T) points_C.push_back(kTargetInCamera + marker);
  see(workplace.rig, points_C, *frame_);
  target_ = std::make_shared<tracking::Target>(std::move(target));
  auto& servo = shown.control.servo;
  servo.at_rest = true;
  servo.measured.q_rad = restingJoints();
  servo.measured.v_rad_s = servo.commanded.v_rad_s = robot::Joints::Zero(7);
  shown.control.X_BF = robot::Kinematics(workplace.arm).flange(restingJoints());
  shown.control.X_BT = shown.control.X_BF * workplace.X_FC;
  shown.control.X_BT = shown.control.X_BT * Eigen::Translation3d(kTargetInCamera);
  shown.frame = frame_;
}

station::Answer FakeStation::request(const station::Command& command) {
  ++requests;
  last_command = command;
  if (answer != station::Answer::kAccepted) return answer;
  const auto next = therapy::after(shown.control.phase, command.action);
  ++shown.control.answers;
  shown.control.last_answer = next ? station::Answer::kAccepted : station::Answer::kNotNow;
  if (next) enter(*next);
  return answer;
}

station::Answer FakeStation::changeHelp(const control::Help& help) {
  if (answer != station::Answer::kAccepted) return answer;
  const bool can = shown.control.servo.assist.gives_way;
  ++shown.control.answers;
  shown.control.last_answer = can ? station::Answer::kAccepted : station::Answer::kHoldsStiffly;
  if (can) shown.control.help = help;
  return answer;
}

void FakeStation::stop(control::StopReason reason) noexcept {
  ++stops;
  shown.control.servo.stop = reason;
  shown.control.servo.category = control::categoryOf(reason);
  shown.control.servo.reset = control::ResetRefusal::kNone;
  if (shown.control.phase == therapy::Phase::kTraining) shown.control.phase = therapy::Phase::kPaused;
}

void FakeStation::setEnabling(control::EnablingPosition position) noexcept {
  shown.control.servo.enabling = position;
}

void FakeStation::resetStop() noexcept {
  ++resets;
  shown.control.servo.stop = control::StopReason::kNone;
  shown.control.servo.category = control::StopCategory::kNone;
  shown.control.servo.reset = control::ResetRefusal::kNotStopped;
}

void FakeStation::enter(therapy::Phase phase) {
  shown.control.phase = phase;
  const bool taught = phase != therapy::Phase::kPrepare && phase != therapy::Phase::kTeaching;
  auto next = std::make_shared<station::TrackedFrame>(*frame_);
  next->target = taught ? target_ : nullptr;
  next->targets.clear();
  if (taught) next->targets.push_back(tracked(static_cast<int>(target_->markers_T.size())));
  frame_ = std::move(next);
  shown.frame = frame_;
  shown.control.target_fresh = taught;
  shown.record.session = phase >= therapy::Phase::kTraining ? 1 : 0;
  shown.record.recording =
      phase == therapy::Phase::kFinished ? station::Recording::kComplete : station::Recording::kIdle;
}

void FakeStation::clutter() {
  auto next = std::make_shared<station::TrackedFrame>(*frame_);
  addRivals(rig_, next->observation);
  clutterImage(next->frame.left, next->observation.left, 2);
  clutterImage(next->frame.right, next->observation.right, 2);
  next->observation.right.exposure.saturated_markers = 8;
  next->observation.right.exposure.warning = vision::ExposureWarning::kSaturated;
  frame_ = std::move(next);
  shown.frame = frame_;
}

void FakeStation::stamp() {
  const TimePoint now = Clock::now();
  auto next = std::make_shared<station::TrackedFrame>(*frame_);
  next->frame.exposed_at = now - std::chrono::milliseconds(30);
  for (auto& target : next->targets) target.exposed_at = next->frame.exposed_at;
  frame_ = std::move(next);
  shown.frame = frame_;
  shown.control.time = now;
  shown.control.servo.time = shown.control.servo.measured.measured_at = now;
}

station::Snapshot FakeStation::snapshot() {
  if (!frozen) stamp();
  return shown;
}

}  // namespace mirrorarm::ui::test
