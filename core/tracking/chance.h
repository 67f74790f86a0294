#pragma once

namespace mirrorarm::tracking {

/// What decides how easily a target fits points that are not its markers.
struct Crowd {
  int markers = 0;         ///< of the target
  int points = 0;          ///< of the cloud
  double pair_rate = 0.0;  ///< share of two points' distances that are like that of two given markers
  double gate_rate = 0.0;  ///< other points in the gate of a marker, on average
};

/// How many fits of `matched` markers, at least 3, chance alone gives in such a cloud: triangles that look
/// like three of the markers, C(J,3) K (K-1) (K-2) p^3, each of which fixes a pose; then every further marker
/// finds a point in its gate with probability q, C(J-3,m-3) q^(m-3); and a fit of m markers has been counted
/// once for each of its C(m,3) triangles.
[[nodiscard]] double expectedChanceFits(const Crowd& crowd, int matched);

/// Share of the distances in an evenly filled ball that lie within `width_m` of `distance_m`.
[[nodiscard]] double pairRateInBall(double distance_m, double width_m, double radius_m);

}  // namespace mirrorarm::tracking
