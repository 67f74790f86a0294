#include "core/vision/blurred_disc.h"

#include <cmath>

#include "core/common/lanes.h"

namespace mirrorarm::vision {
namespace {

using lanes::Floats;
using lanes::Ints;

constexpr float kLeastVariance = 1.0F / 12.0F;  // grey^2, of rounding to whole grey values
constexpr float kReach = 8.0F;                  // blurs from the outline: beyond it nothing changes
constexpr float kOutside = 1.5F;                // blurs: farther out a bright pixel belongs to something else
constexpr float kIntruderNoises = 5.0F;
constexpr float kIntruderShare = 0.06F;  // of the light: the soft rim leaves less than that out there
constexpr float kInverseRoot2Pi = 0.39894228F;
constexpr float kFull = 254.5F;
constexpr float kTiny = 1e-12F;

/// The disc in the numbers of the inner loop, relative to the window's first pixel.
struct Model {
  float cx, cy, bxx, bxy, byy, blur, ground, light, ramp_x, ramp_y;
  float cover_x, cover_y, cover_offset;
  float dark, lit, intruder;
  float det2;  // of B, squared
};

Model modelOf(const BlurredDisc& disc, const PixelNoise& noise, const Region& window) {
  const auto f = [](double value) { return static_cast<float>(value); };
  Model m{};
  m.cx = f(disc.centre_px.x() - window.left);
  m.cy = f(disc.centre_px.y() - window.top);
  m.bxx = f(disc.B_per_px(0, 0));
  m.bxy = f(disc.B_per_px(0, 1));
  m.byy = f(disc.B_per_px(1, 1));
  m.blur = f(disc.blur_px);
  m.ground = f(disc.ground);
  m.light = f(disc.light);
  m.ramp_x = disc.covered ? 0.0F : f(disc.ramp_per_px.x());
  m.ramp_y = disc.covered ? 0.0F : f(disc.ramp_per_px.y());
  m.cover_x = f(std::cos(disc.cover_direction_rad));
  m.cover_y = f(std::sin(disc.cover_direction_rad));
  m.cover_offset = f(disc.cover_offset_px);
  m.dark = f(noise.dark);
  m.lit = f(noise.lit);
  m.det2 = (m.bxx * m.byy - m.bxy * m.bxy) * (m.bxx * m.byy - m.bxy * m.bxy);
  m.intruder = std::max(kIntruderNoises * std::sqrt(m.dark), kIntruderShare * m.light);
  return m;
}

/// Phi(-t) and its density, Abramowitz and Stegun 7.1.26, to 2e-7.
struct Tail {
  Floats share;
  Floats density;
};

MIRRORARM_INLINE Tail tailAt(const Floats& t) {
  const Floats magnitude = lanes::least(t < 0.0F ? -t : t, lanes::all(kReach));
  const Floats bell = lanes::exponential(-0.5F * magnitude * magnitude);
  const Floats k = 1.0F / (1.0F + 0.23164189F * magnitude);
  Floats p = 1.061405429F * k - 1.453152027F;
  p = p * k + 1.421413741F;
  p = p * k - 0.284496736F;
  p = p * k + 0.254829592F;
  const Floats tail = 0.5F * p * k * bell;
  return {t > 0.0F ? tail : 1.0F - tail, kInverseRoot2Pi * bell};
}

/// Everything that the model says of eight pixels of a row.
struct Eight {
  Floats rx, ry, ux, uy, wx, wy, zx, zy;
  Floats alpha, beta;  // of the distance's derivative: d' = alpha u.u' - beta (w.u' B + ...)
  Floats distance, slope_x, slope_y, bend;
  Floats rim;    // density / blur
  Floats share;  // S
  Floats gain;   // light with its ramp
  Floats expected;
  // with a cover
  Floats cover_share, cover_rim, disc_share;
};

/// What two blurred edges share at their corner beyond the product of both, over the product of their
/// densities: the bivariate normal distribution as a series in the cosine between their normals (Mehler).
MIRRORARM_INLINE Floats cornerSeries(const Floats& h, const Floats& k, const Floats& rho) {
  const Floats h2 = h * h, k2 = k * k;
  const Floats third = (h2 - 1.0F) * (k2 - 1.0F) / 6.0F;
  const Floats fourth = h * k * (h2 - 3.0F) * (k2 - 3.0F) / 24.0F;
  const Floats fifth = (h2 * h2 - 6.0F * h2 + 3.0F) * (k2 * k2 - 6.0F * k2 + 3.0F) / 120.0F;
  return rho * (1.0F + rho * (0.5F * h * k + rho * (third + rho * (fourth + rho * fifth))));
}

template <bool kCovered>
MIRRORARM_INLINE Eight modelAt(const Model& m, const Floats& rx, float ry) {
  Eight e;
  e.rx = rx;
  e.ry = lanes::all(ry);
  e.ux = m.bxx * e.rx + m.bxy * e.ry;
  e.uy = m.bxy * e.rx + m.byy * e.ry;
  e.wx = m.bxx * e.ux + m.bxy * e.uy;
  e.wy = m.bxy * e.ux + m.byy * e.uy;
  e.zx = m.bxx * e.wx + m.bxy * e.wy;
  e.zy = m.bxy * e.wx + m.byy * e.wy;
  const Floats s2 = e.ux * e.ux + e.uy * e.uy + kTiny;
  const Floats inverse_s = lanes::inverseRoot(s2);
  const Floats s = s2 * inverse_s;
  const Floats inverse_g = lanes::inverseRoot(e.wx * e.wx + e.wy * e.wy + kTiny);
  const Floats to_rim = s * inverse_g;  // blurs a convex rim inwards: half the variance times its curvature
  e.bend = m.blur * m.det2 * to_rim * to_rim * to_rim;
  e.distance = (s2 - s) * inverse_g;
  e.alpha = (2.0F * s - 1.0F) * inverse_g * inverse_s;
  e.beta = e.distance * inverse_g * inverse_g;
  const Floats yx = m.bxx * e.zx + m.bxy * e.zy;
  const Floats yy = m.bxy * e.zx + m.byy * e.zy;
  e.slope_x = e.alpha * e.wx - e.beta * yx;
  e.slope_y = e.alpha * e.wy - e.beta * yy;
  e.distance += 0.5F * m.blur * e.bend;
  const float sharpness = 1.0F / m.blur;
  const Tail tail = tailAt(e.distance * sharpness);
  e.share = tail.share;
  e.rim = tail.density * sharpness;
  e.gain = m.light + m.ramp_x * e.rx + m.ramp_y * e.ry;
  if constexpr (kCovered) {
    const Floats across = (m.cover_x * e.rx + m.cover_y * e.ry - m.cover_offset) * sharpness;
    const Tail cover = tailAt(across);
    e.disc_share = e.share;
    e.cover_share = cover.share;
    e.cover_rim = cover.density * sharpness;
    const Floats rho = m.cover_x * e.slope_x + m.cover_y * e.slope_y;
    e.share = e.disc_share * e.cover_share +
              tail.density * cover.density * cornerSeries(e.distance * sharpness, across, rho);
  }
  const Floats ramp_slope = m.ramp_x * e.slope_x + m.ramp_y * e.slope_y;
  e.expected = m.ground + e.gain * e.share - m.blur * m.blur * ramp_slope * e.rim;
  return e;
}

/// What a pixel leaves over: residual, and the inverse of its standard deviation, both 0 where it says
/// nothing; and the residual by its deviation, which for an intruder stays at the limit, so that the sum of
/// squares does not leap when a pixel becomes one.
struct Left {
  Floats residual;
  Floats certainty;
  Floats normalised;
};

MIRRORARM_INLINE Left compare(const Model& m, const Eight& e, const Floats& seen) {
  const Floats none{};
  const Ints censored = (seen > kFull) & (e.expected > kFull);
  const Floats residual = censored ? none : seen - e.expected;
  // Where the ground is noisier than the light, rounding could take the sum below zero.
  const Floats variance = lanes::most(m.dark + m.lit * e.share, lanes::all(kLeastVariance));
  const Floats certainty = lanes::inverseRoot(variance);
  const Ints intruder = (e.distance > kOutside * m.blur) & (residual > m.intruder);
  const Ints silent = censored | intruder;
  return {silent ? none : residual, silent ? none : certainty,
          certainty * (intruder ? lanes::all(m.intruder) : residual)};
}

template <bool kCovered>
MIRRORARM_INLINE void derivatives(const Model& m, const Eight& e, Floats (&J)[kDiscParameters]) {
  // S falls by `rim` for each pixel that the distance grows.
  Floats edge = e.gain * e.rim;
  if constexpr (kCovered) edge *= e.cover_share;
  J[kCentreX] = edge * e.slope_x;
  J[kCentreY] = edge * e.slope_y;
  J[kBxx] = -edge * (e.alpha * e.ux * e.rx - e.beta * (e.wx * e.ux + e.zx * e.rx));
  J[kBxy] = -edge * (e.alpha * (e.ux * e.ry + e.uy * e.rx) -
                     e.beta * (e.wx * e.uy + e.wy * e.ux + e.zx * e.ry + e.zy * e.rx));
  J[kByy] = -edge * (e.alpha * e.uy * e.ry - e.beta * (e.wy * e.uy + e.zy * e.ry));
  J[kBlur] = edge * (e.distance / m.blur - e.bend);
  J[kGround] = lanes::all(1.0F);
  J[kLight] = e.share;
  if constexpr (kCovered) {
    const Floats across = m.cover_x * e.rx + m.cover_y * e.ry;
    const Floats along = m.cover_x * e.ry - m.cover_y * e.rx;
    const Floats cover_edge = e.gain * e.disc_share * e.cover_rim;
    // The cover is given relative to the centre, which takes it along.
    J[kCentreX] += cover_edge * m.cover_x;
    J[kCentreY] += cover_edge * m.cover_y;
    J[kBlur] += cover_edge * (across - m.cover_offset) / m.blur;
    J[kExtra1] = -cover_edge * along;
    J[kExtra2] = cover_edge;
  } else {
    const float blur2 = m.blur * m.blur;
    J[kCentreX] -= m.ramp_x * e.share;
    J[kCentreY] -= m.ramp_y * e.share;
    J[kExtra1] = e.rx * e.share - blur2 * e.rim * e.slope_x;
    J[kExtra2] = e.ry * e.share - blur2 * e.rim * e.slope_y;
  }
}

MIRRORARM_INLINE Floats seenAt(const Brightness& image, const std::uint8_t* pixels) {
  const Floats seen = lanes::floatsOf(pixels);
  return image.flip == 0 ? seen : 255.0F - seen;
}

// Derivatives are laid down a strip at a time, a column a parameter and one for the residuals, all by their
// standard deviation; then the products of the columns are summed three by three, which stays in registers.
constexpr int kColumns = 12;  // the last one stays zero: a multiple of three
constexpr int kResidual = kDiscParameters;
constexpr int kStrip = 40;  // eights of pixels: the columns stay in the first cache

struct Strip {
  Floats column[kColumns][kStrip];
};

/// Sums over eight pixels side by side.
struct Sums {
  Floats product[kColumns][kColumns]{};
  Floats pixels{}, share{}, share2{}, square{}, share_square{};
};

/// Where the next eight pixels are.
struct Cursor {
  int x = 0;
  int y = 0;
};

template <bool kCovered>
MIRRORARM_INLINE int fill(const Model& m, const Brightness& image, const Region& window, Cursor& cursor,
                          Strip& strip, Sums& sums) {
  int count = 0;
  for (; count < kStrip && cursor.y < window.height(); ++count) {
    const std::uint8_t* pixels = image.image.row(window.top + cursor.y) + window.left + cursor.x;
    const Eight e = modelAt<kCovered>(m, lanes::counting() + (static_cast<float>(cursor.x) - m.cx),
                                      static_cast<float>(cursor.y) - m.cy);
    const Left left = compare(m, e, seenAt(image, pixels));
    Floats J[kDiscParameters];
    derivatives<kCovered>(m, e, J);
    for (int i = 0; i < kDiscParameters; ++i) strip.column[i][count] = left.certainty * J[i];
    strip.column[kResidual][count] = left.normalised;
    strip.column[kResidual + 1][count] = Floats{};
    const Floats speaks = left.certainty > 0.0F ? lanes::all(1.0F) : Floats{};
    const Floats square = left.residual * left.residual;
    sums.pixels += speaks;
    sums.share += speaks * e.share;
    sums.share2 += speaks * e.share * e.share;
    sums.square += square;
    sums.share_square += square * e.share;
    cursor.x += lanes::kCount;
    if (cursor.x < window.width()) continue;
    cursor.x = 0;
    ++cursor.y;
  }
  return count;
}

MIRRORARM_INLINE void addProducts(const Strip& strip, int count, int i, int j, Sums& sums) {
  const Floats* a = strip.column[i];
  const Floats* b = strip.column[j];
  Floats p00{}, p01{}, p02{}, p10{}, p11{}, p12{}, p20{}, p21{}, p22{};
  for (int k = 0; k < count; ++k) {
    const Floats a0 = a[k], a1 = a[k + kStrip], a2 = a[k + 2 * kStrip];
    const Floats b0 = b[k], b1 = b[k + kStrip], b2 = b[k + 2 * kStrip];
    p00 += a0 * b0, p01 += a0 * b1, p02 += a0 * b2;
    p10 += a1 * b0, p11 += a1 * b1, p12 += a1 * b2;
    p20 += a2 * b0, p21 += a2 * b1, p22 += a2 * b2;
  }
  auto& p = sums.product;
  p[i][j] += p00, p[i][j + 1] += p01, p[i][j + 2] += p02;
  p[i + 1][j] += p10, p[i + 1][j + 1] += p11, p[i + 1][j + 2] += p12;
  p[i + 2][j] += p20, p[i + 2][j + 1] += p21, p[i + 2][j + 2] += p22;
}

template <bool kCovered>
MIRRORARM_INLINE void sumUp(const Model& m, const Brightness& image, const Region& window, Sums& sums) {
  Strip strip;
  for (Cursor cursor; cursor.y < window.height();) {
    const int count = fill<kCovered>(m, image, window, cursor, strip, sums);
    for (int i = 0; i < kColumns; i += 3)
      for (int j = 0; j <= i; j += 3) addProducts(strip, count, i, j, sums);
  }
}

MIRRORARM_VECTOR_CODE void sumUpWhole(const Model& m, const Brightness& image, const Region& window,
                                      Sums& sums) {
  sumUp<false>(m, image, window, sums);
}

MIRRORARM_VECTOR_CODE void sumUpCovered(const Model& m, const Brightness& image, const Region& window,
                                        Sums& sums) {
  sumUp<true>(m, image, window, sums);
}

template <bool kCovered>
MIRRORARM_INLINE void leaveOver(const Model& m, const Brightness& image, const Region& window,
                                DiscResiduals& result) {
  std::size_t at = 0;
  for (int y = 0; y < window.height(); ++y) {
    const std::uint8_t* row = image.image.row(window.top + y) + window.left;
    for (int x = 0; x < window.width(); x += lanes::kCount, at += lanes::kCount) {
      const Eight e = modelAt<kCovered>(m, lanes::counting() + (static_cast<float>(x) - m.cx),
                                        static_cast<float>(y) - m.cy);
      Floats slope = e.gain * e.rim;
      if constexpr (kCovered) slope *= e.cover_share;
      lanes::store(&result.residual[at], compare(m, e, seenAt(image, row + x)).residual);
      lanes::store(&result.share[at], e.share);
      lanes::store(&result.slope[at], slope);
      lanes::store(&result.ux[at], e.ux);
      lanes::store(&result.uy[at], e.uy);
    }
  }
}

MIRRORARM_VECTOR_CODE void leaveOverWhole(const Model& m, const Brightness& image, const Region& window,
                                          DiscResiduals& result) {
  leaveOver<false>(m, image, window, result);
}

MIRRORARM_VECTOR_CODE void leaveOverCovered(const Model& m, const Brightness& image, const Region& window,
                                            DiscResiduals& result) {
  leaveOver<true>(m, image, window, result);
}

}  // namespace

void normalEquations(const BlurredDisc& disc, const PixelNoise& noise, const Brightness& image,
                     const Region& window, DiscEquations& equations) {
  const Model m = modelOf(disc, noise, window);
  Sums sums;
  if (disc.covered)
    sumUpCovered(m, image, window, sums);
  else
    sumUpWhole(m, image, window, sums);
  for (int i = 0; i < kDiscParameters; ++i) {
    for (int j = 0; j <= i; ++j)
      equations.matrix(i, j) = equations.matrix(j, i) = lanes::sum(sums.product[i][j]);
    equations.vector(i) = lanes::sum(sums.product[kResidual][i]);
  }
  equations.squares = lanes::sum(sums.product[kResidual][kResidual]);
  equations.pixels = lanes::sum(sums.pixels);
  equations.share = lanes::sum(sums.share);
  equations.share2 = lanes::sum(sums.share2);
  equations.square = lanes::sum(sums.square);
  equations.share_square = lanes::sum(sums.share_square);
}

void residuals(const BlurredDisc& disc, const PixelNoise& noise, const Brightness& image,
               const Region& window, DiscResiduals& result) {
  result.width = window.width();
  result.height = window.height();
  const auto count = static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height);
  for (auto* map : {&result.residual, &result.share, &result.slope, &result.ux, &result.uy})
    map->resize(count);
  const Model m = modelOf(disc, noise, window);
  if (disc.covered)
    leaveOverCovered(m, image, window, result);
  else
    leaveOverWhole(m, image, window, result);
}

}  // namespace mirrorarm::vision
