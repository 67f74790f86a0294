#include <cmath>

#include "core/common/yaml.h"
#include "core/simulation/bench_layout.h"
#include "core/simulation/exercise_motion.h"
#include "core/simulation/scene.h"

namespace mirrorarm::simulation {
namespace {

double numberIn(const YamlNode& node, double least, double most) {
  const double value = node.number();
  if (value < least || value > most)
    node.refuse("is not between " + std::to_string(least) + " and " + std::to_string(most));
  return value;
}

long long wholeIn(const YamlNode& node, long long least, long long most) {
  const long long value = node.integer();
  if (value < least || value > most)
    node.refuse("is not between " + std::to_string(least) + " and " + std::to_string(most));
  return value;
}

/// A length of more than 10 m is a slip of units.
Eigen::Vector3d placeIn(const YamlNode& node) {
  const Eigen::Vector3d place = node.vector3();
  if (place.cwiseAbs().maxCoeff() > 10.0) node.refuse("is more than 10 m away");
  return place;
}

RigidTransform poseIn(const YamlNode& node) {
  node.allowOnly({"translation_m", "rotation_xyzw"});
  return makeTransform(node["rotation_xyzw"].quaternion(), placeIn(node["translation_m"]));
}

template <class Read>
auto listIn(const YamlNode& node, Read read) {
  std::vector<decltype(read(node))> items;
  for (std::size_t i = 0; i < node.size(); ++i) items.push_back(read(node[i]));
  return items;
}

std::filesystem::path rigIn(const YamlNode& node, const Scene& scene,
                            const std::filesystem::path& resources) {
  const std::string name = node.text();
  if (name == "fisheye" || name == "pinhole") return resources / "rigs" / (name + ".yaml");
  return scene.file.parent_path() / name;
}

void readLight(const YamlNode& node, LightSettings& light) {
  node.allowOnly({"spread_sigma_px", "bright_level"});
  if (node.has("spread_sigma_px")) light.spread_sigma_px = numberIn(node["spread_sigma_px"], 0.3, 5.0);
  if (node.has("bright_level")) light.bright_level = numberIn(node["bright_level"], 1.0, 1000.0);
}

void readSensor(const YamlNode& node, SensorSettings& sensor) {
  node.allowOnly({"background", "electrons_per_level", "read_noise"});
  if (node.has("background")) sensor.background = numberIn(node["background"], 0.0, 200.0);
  if (node.has("electrons_per_level"))
    sensor.electrons_per_level = numberIn(node["electrons_per_level"], 0.1, 1e6);
  if (node.has("read_noise")) sensor.read_noise = numberIn(node["read_noise"], 0.0, 50.0);
}

Scene::Grid gridIn(const YamlNode& node) {
  constexpr double kMostSteps = 50.0;
  node.allowOnly({"size_m", "step_m", "frames_per_station"});
  Scene::Grid grid;
  grid.size_m = placeIn(node["size_m"]);
  grid.step_m = numberIn(node["step_m"], 1e-4, 1.0);
  grid.frames = static_cast<int>(wholeIn(node["frames_per_station"], 1, 1000));
  if (grid.size_m.minCoeff() < 0.0 || grid.size_m.maxCoeff() > kMostSteps * grid.step_m)
    node["size_m"].refuse("is not between 0 and 50 steps");
  return grid;
}

Scene::Camera cameraIn(const YamlNode& node) {
  node.allowOnly({"on_robot", "pose", "grid"});
  Scene::Camera camera;
  camera.on_robot = node["on_robot"].flag();
  if (node.has("pose") || !camera.on_robot)
    camera.X_WC = poseIn(node["pose"]);
  else
    camera.X_WC = bench_layout::startX_BC();
  if (node.has("grid")) camera.grid = gridIn(node["grid"]);
  return camera;
}

MinimumJerkLeg legIn(const YamlNode& node) {
  node.allowOnly({"displacement_m", "turn_rad", "duration_s", "rest_s"});
  MinimumJerkLeg leg;
  leg.displacement_m = placeIn(node["displacement_m"]);
  leg.duration_s = numberIn(node["duration_s"], 0.05, 1000.0);
  if (node.has("turn_rad")) leg.forearm_turn_rad = numberIn(node["turn_rad"], -7.0, 7.0);
  if (node.has("rest_s")) leg.rest_s = numberIn(node["rest_s"], 0.0, 1000.0);
  return leg;
}

Disc markerIn(const YamlNode& node) {
  node.allowOnly({"position_m", "normal"});
  Disc disc;
  disc.p_B = placeIn(node["position_m"]);
  disc.normal_B = node["normal"].vector3();
  if (std::abs(disc.normal_B.norm() - 1.0) > 0.01) node["normal"].refuse("is not of length 1");
  return disc;
}

void checkApart(const YamlNode& node, const std::vector<Disc>& discs, double diameter_m) {
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if ((discs[i].p_B - discs[k].p_B).norm() < diameter_m)
        node[i].refuse("overlaps marker " + std::to_string(k));
}

/// The discs around their centroid.
std::vector<Disc> layoutIn(const YamlNode& node, double diameter_m) {
  if (node.has("layout") == node.has("markers")) node.refuse("needs either layout or markers");
  std::vector<Disc> discs = sleeveDiscs();
  if (node.has("markers")) {
    const auto markers = node["markers"];
    if (markers.size() < 3 || markers.size() > 200) markers.refuse("does not hold between 3 and 200 markers");
    discs = listIn(markers, markerIn);
    checkApart(markers, discs, diameter_m);
  } else if (node["layout"].text() != "sleeve") {
    node["layout"].refuse("is not sleeve");
  }
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const Disc& disc : discs) centroid += disc.p_B / static_cast<double>(discs.size());
  for (Disc& disc : discs) {
    disc.p_B -= centroid;
    disc.diameter_m = diameter_m;
  }
  return discs;
}

std::string nameIn(const YamlNode& node) {
  const std::string name = node.text();
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.empty() || name.size() > 64 || name.find_first_not_of(kAllowed) != std::string::npos)
    node.refuse("is not a name of letters, digits, '-' and '_'");
  return name;
}

void readUr5(const YamlNode& node, Scene::Target& target) {
  node.allowOnly({"base", "target_on_flange", "posture_rad"});
  target.X_WU = poseIn(node["base"]);
  target.X_FT = poseIn(node["target_on_flange"]);
  target.posture_rad = node["posture_rad"].numbers();
  if (target.posture_rad.size() != 6) node["posture_rad"].refuse("does not hold six angles");
}

Scene::Target targetIn(const YamlNode& node, const Scene& scene) {
  node.allowOnly(
      {"name", "marker_diameter_m", "layout", "markers", "carried_by", "pose", "legs", "motion", "ur5"});
  Scene::Target target;
  target.name = nameIn(node["name"]);
  if (node.has("marker_diameter_m"))
    target.marker_diameter_m = numberIn(node["marker_diameter_m"], 0.0005, 0.2);
  const auto carrier = carrierOf(node["carried_by"].text());
  if (!carrier) node["carried_by"].refuse("is none of table, forearm, ur5");
  target.carried_by = *carrier;
  target.X_WT = poseIn(node["pose"]);
  if (node.has("legs")) target.legs = listIn(node["legs"], legIn);
  if (node.has("motion")) target.motion = scene.file.parent_path() / node["motion"].text();
  if (node.has("legs") && *carrier == Carrier::kTable) node["legs"].refuse("does not go with a table");
  if (node.has("motion") && (*carrier != Carrier::kForearm || node.has("legs")))
    node["motion"].refuse("goes with a forearm without legs alone");
  if (node.has("ur5") != (*carrier == Carrier::kUr5))
    node.refuse("has ur5 and carried_by that contradict each other");
  if (node.has("ur5")) readUr5(node["ur5"], target);
  if (target.motion.empty())
    target.discs_T = layoutIn(node, target.marker_diameter_m);
  else if (node.has("layout") || node.has("markers"))
    node.refuse("has markers beside those of its motion");
  return target;
}

Patch patchIn(const YamlNode& node) {
  node.allowOnly({"outline", "centre_m", "u_m", "v_m", "strength", "glows"});
  Patch patch;
  const std::string outline = node["outline"].text();
  if (outline != "ellipse" && outline != "rectangle")
    node["outline"].refuse("is neither ellipse nor rectangle");
  patch.outline = outline == "ellipse" ? Patch::Outline::kEllipse : Patch::Outline::kRectangle;
  patch.centre = placeIn(node["centre_m"]);
  patch.u = placeIn(node["u_m"]);
  patch.v = placeIn(node["v_m"]);
  if (patch.u.cross(patch.v).norm() < 1e-9) node["v_m"].refuse("gives no area with u_m");
  patch.strength = numberIn(node["strength"], 0.0, 100.0);
  patch.retroreflective = !node["glows"].flag();
  return patch;
}

int framesIn(const YamlNode& root, const Scene& scene) {
  constexpr long long kMost = 100000;
  if (!scene.camera.grid) return static_cast<int>(wholeIn(root["frames"], 1, kMost));
  if (root.has("frames")) root["frames"].refuse("does not go with a grid, which gives the number of frames");
  const long long frames =
      static_cast<long long>(stationsOf(*scene.camera.grid).size()) * scene.camera.grid->frames;
  if (frames > kMost) root["camera"]["grid"].refuse("gives more than 100000 frames");
  return static_cast<int>(frames);
}

Scene sceneIn(const YamlNode& root, Scene scene, const std::filesystem::path& resources) {
  root.allowOnly({"format", "rig", "seed", "frames", "rate_hz", "exposure_s", "light", "sensor", "camera",
                  "target", "clutter", "covered_share"});
  scene.rig = rigIn(root["rig"], scene, resources);
  if (root.has("seed"))
    scene.seed = static_cast<std::uint64_t>(wholeIn(root["seed"], 0, 9'000'000'000'000'000));
  if (root.has("rate_hz")) scene.rate_hz = numberIn(root["rate_hz"], 0.01, 2000.0);
  if (root.has("exposure_s"))
    scene.exposure = Seconds(numberIn(root["exposure_s"], 0.0, 1.0 / scene.rate_hz));
  if (root.has("light")) readLight(root["light"], scene.light);
  if (root.has("sensor")) readSensor(root["sensor"], scene.sensor);
  scene.camera = cameraIn(root["camera"]);
  scene.target = targetIn(root["target"], scene);
  if (root.has("clutter")) scene.clutter_W = listIn(root["clutter"], patchIn);
  if (root.has("covered_share")) scene.covered_share = numberIn(root["covered_share"], 0.0, 1.0);
  scene.frames = framesIn(root, scene);
  return scene;
}

}  // namespace

FromFile<Scene> readScene(const std::filesystem::path& file, const std::filesystem::path& resources) {
  Scene scene;
  scene.file = file;
  return readYaml(file, "mirrorarm/scene/1",
                  [&](const YamlNode& root) { return sceneIn(root, std::move(scene), resources); });
}

}  // namespace mirrorarm::simulation
