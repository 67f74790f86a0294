#include "core/calibration/dot_pattern.h"

#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

namespace mirrorarm::calibration {
namespace {

constexpr int kPeriod = 65535;
constexpr std::uint32_t kPolynomial = 0x1'01bf;  // x^16 + x^8 + x^7 + x^5 + x^4 + x^3 + x^2 + x + 1
/// Where the sequence begins: so that the corner of the pattern, 9 by 7 dots, is told apart best.
constexpr std::uint32_t kStart = 0x16fa;
/// Leaves 1 divided by 255 and 0 by 257; and the other way round: the diagonal's place by column and row.
constexpr int kPerColumn = 32896, kPerRow = 32640;

std::vector<bool> sequence() {
  std::vector<bool> bits;
  bits.reserve(kPeriod);
  for (std::uint32_t state = kStart; bits.size() < kPeriod;) {
    bits.push_back((state & 1U) != 0);
    const auto next = static_cast<std::uint32_t>(std::popcount(state & (kPolynomial & 0xffffU))) & 1U;
    state = state >> 1 | next << 15;
  }
  return bits;
}

}  // namespace

bool isLargeDot(int column, int row) {
  assert(column >= 0 && column < 10000 && row >= 0 && row < 10000);
  static const auto bits = sequence();
  return bits[static_cast<std::size_t>((kPerColumn * column + kPerRow * row) % kPeriod)];
}

}  // namespace mirrorarm::calibration
