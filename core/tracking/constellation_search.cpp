#include "core/tracking/constellation_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/tracking/distance_index.h"
#include "core/tracking/target_search.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;

// Bounds what a degenerate target or cloud (a grid, copies of one point) may cost.
constexpr std::size_t kMostAgreements = 600'000;
// Two targets that share so many points claim the same place; fewer may be a stranger's accident.
constexpr int kPointsOfAPlace = 3;

int sharedPoints(const Constellation& a, const Constellation& b, const SearchCloud& cloud) {
  int shared = 0;
  for (const int k : a.point_of_marker) {
    if (k < 0) continue;
    shared += static_cast<int>(std::ranges::any_of(b.point_of_marker, [&](int l) {
      return l >= 0 && (k == l || shareADisc(cloud[k].discs, cloud[l].discs));
    }));
  }
  return shared;
}

}  // namespace

struct ConstellationSearch::Body {
  explicit Body(const ConstellationSettings& each) : settings(each), search(each) {}

  struct Claim {
    bool wanted = false;
    bool decided = false;
  };

  void listAgreements();
  void seek(std::size_t target);
  void settleClaims();
  [[nodiscard]] std::size_t surest() const;
  void compareWithRivals(std::size_t target);
  void grant(std::size_t target);
  [[nodiscard]] bool needsTakenPoints(std::size_t target) const;

  ConstellationSettings settings;
  std::vector<std::vector<Vector3d>> targets;
  std::vector<double> tolerances_m;
  double widest_tolerance_m = 0.0;
  DistanceIndex index;
  SearchCloud cloud;
  std::vector<std::vector<Agreement>> agreements;
  TargetSearch search;
  std::vector<char> free;
  std::vector<Claim> claims;
  std::vector<SearchResult> results;
};

/// Looks every distance of the cloud up in the targets'.
void ConstellationSearch::Body::listAgreements() {
  for (auto& each : agreements) each.clear();
  const double longest_m =
      index.longest() + widest_tolerance_m + settings.sigmas * std::numbers::sqrt2 * cloud.mostSigma();
  for (int l = 1; l < cloud.size(); ++l)
    for (int k = 0; k < l; ++k) {
      const Vector3d between = cloud.at(l) - cloud.at(k);
      const double square = between.squaredNorm();
      if (!(square > 0.0) || square > longest_m * longest_m || shareADisc(cloud[k].discs, cloud[l].discs))
        continue;
      const double distance_m = std::sqrt(square);
      const double allowed_m = settings.sigmas * cloud.sigmaOfDistance(k, l, between);
      index.forEachNear(distance_m, allowed_m + widest_tolerance_m, [&](const DistanceIndex::Entry& entry) {
        auto& of_target = agreements[entry.target];
        if (claims[entry.target].wanted && of_target.size() < kMostAgreements &&
            std::abs(entry.distance_m - distance_m) <= allowed_m + tolerances_m[entry.target])
          of_target.push_back({entry.a, entry.b, static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(l)});
      });
    }
}

void ConstellationSearch::Body::seek(std::size_t target) {
  if (agreements[target].size() < kMostAgreements)
    search.run({targets[target], tolerances_m[target], &cloud, agreements[target], free}, results[target]);
  else
    results[target].verdict = SearchVerdict::kCutOff;
}

/// The surest fit takes its points; one that wanted some of them is sought anew among the rest.
void ConstellationSearch::Body::settleClaims() {
  for (std::size_t target = surest(); target < targets.size(); target = surest()) {
    if (needsTakenPoints(target)) {
      seek(target);
      continue;
    }
    compareWithRivals(target);
    grant(target);
  }
}

std::size_t ConstellationSearch::Body::surest() const {
  std::size_t best = targets.size();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!claims[i].wanted || claims[i].decided || results[i].best.matched == 0) continue;
    if (best == targets.size() || results[i].best.evidence > results[best].best.evidence) best = i;
  }
  return best;
}

bool ConstellationSearch::Body::needsTakenPoints(std::size_t target) const {
  return std::ranges::any_of(results[target].best.point_of_marker, [&](int point) {
    return point >= 0 && free[static_cast<std::size_t>(point)] == 0;
  });
}

/// What chance may have made is no rival.
void ConstellationSearch::Body::compareWithRivals(std::size_t target) {
  if (results[target].verdict == SearchVerdict::kTooFewMarkers) return;
  const double clear_odds = -std::log(settings.max_chance);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i == target || !claims[i].wanted || claims[i].decided ||
        results[i].verdict == SearchVerdict::kTooFewMarkers ||
        sharedPoints(results[target].best, results[i].best, cloud) < kPointsOfAPlace ||
        results[target].best.evidence - results[i].best.evidence >= clear_odds)
      continue;
    for (const std::size_t each : {target, i})
      if (results[each].verdict == SearchVerdict::kFound) results[each].verdict = SearchVerdict::kAmbiguous;
    claims[i].decided = true;
  }
}

void ConstellationSearch::Body::grant(std::size_t target) {
  claims[target].decided = true;
  const auto& result = results[target];
  if (result.verdict != SearchVerdict::kFound && result.verdict != SearchVerdict::kAmbiguous) return;
  for (const int taken : result.best.point_of_marker) {
    if (taken < 0) continue;
    for (int point = 0; point < cloud.size(); ++point)
      if (point == taken || shareADisc(cloud[taken].discs, cloud[point].discs))
        free[static_cast<std::size_t>(point)] = 0;
  }
}

ConstellationSearch::ConstellationSearch(const ConstellationSettings& settings)
    : body_(std::make_unique<Body>(settings)) {}
ConstellationSearch::~ConstellationSearch() = default;
ConstellationSearch::ConstellationSearch(ConstellationSearch&&) noexcept = default;
ConstellationSearch& ConstellationSearch::operator=(ConstellationSearch&&) noexcept = default;

void ConstellationSearch::setTargets(std::span<const std::span<const Vector3d>> targets_T,
                                     std::span<const double> tolerances_m) {
  assert(tolerances_m.empty() || tolerances_m.size() == targets_T.size());
  Body& body = *body_;
  body.targets.resize(targets_T.size());
  for (std::size_t i = 0; i < targets_T.size(); ++i) {
    assert(targets_T[i].size() <= static_cast<std::size_t>(kMaxMarkers));
    body.targets[i].assign(targets_T[i].begin(), targets_T[i].end());
  }
  body.tolerances_m.assign(targets_T.size(), body.settings.tolerance_m);
  std::ranges::copy(tolerances_m, body.tolerances_m.begin());
  body.widest_tolerance_m = body.targets.empty() ? 0.0 : *std::ranges::max_element(body.tolerances_m);
  body.index.build(body.targets);
  body.agreements.resize(targets_T.size());
  body.claims.resize(targets_T.size());
  body.results.resize(targets_T.size());
}

std::span<const SearchResult> ConstellationSearch::run(std::span<const CloudPoint> cloud,
                                                       std::span<const char> wanted) {
  Body& body = *body_;
  assert(wanted.empty() || wanted.size() == body.targets.size());
  body.cloud.take(cloud, body.settings.unknown_sigma_m);
  body.free.assign(static_cast<std::size_t>(body.cloud.size()), 1);
  for (std::size_t i = 0; i < body.targets.size(); ++i)
    body.claims[i] = {wanted.empty() || wanted[i] != 0, false};
  body.listAgreements();
  for (std::size_t i = 0; i < body.targets.size(); ++i) {
    forget(body.results[i], body.targets[i].size());
    if (body.claims[i].wanted) body.seek(i);
  }
  body.settleClaims();
  return body.results;
}

}  // namespace mirrorarm::tracking
