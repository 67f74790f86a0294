#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mirrorarm::devices {

/// The unsigned number in the first bytes, most significant first. At least sizeof(Number) of them.
template <std::unsigned_integral Number>
[[nodiscard]] Number bigEndian(std::span<const std::byte> bytes) {
  Number value = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    value = static_cast<Number>(value << 8 | std::to_integer<Number>(bytes[i]));
  return value;
}

[[nodiscard]] inline float bigEndianFloat(std::span<const std::byte> bytes) {
  return std::bit_cast<float>(bigEndian<std::uint32_t>(bytes));
}

/// Into the first sizeof(Number) bytes.
template <std::unsigned_integral Number>
void putBigEndian(Number value, std::span<std::byte> bytes) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes[i] = static_cast<std::byte>(value >> (8 * (sizeof(Number) - 1 - i)) & 0xFF);
}

template <std::unsigned_integral Number>
void appendBigEndian(std::vector<std::byte>& bytes, Number value) {
  for (std::size_t i = sizeof(Number); i-- > 0;)
    bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFF));
}

}  // namespace mirrorarm::devices
