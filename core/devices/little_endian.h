#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mirrorarm::devices {

/// Takes numbers one after another from bytes, least significant first. The bytes must suffice.
class LittleEndianReader {
 public:
  explicit LittleEndianReader(std::span<const std::byte> bytes) noexcept : rest_(bytes) {}

  template <std::unsigned_integral Number>
  void operator()(Number& value) noexcept {
    value = 0;
    for (std::size_t i = sizeof(Number); i-- > 0;)
      value = static_cast<Number>(value << 8 | std::to_integer<Number>(rest_[i]));
    rest_ = rest_.subspan(sizeof(Number));
  }
  void operator()(std::int32_t& value) noexcept {
    std::uint32_t bits = 0;
    (*this)(bits);
    value = std::bit_cast<std::int32_t>(bits);
  }
  void operator()(float& value) noexcept {
    std::uint32_t bits = 0;
    (*this)(bits);
    value = std::bit_cast<float>(bits);
  }
  template <class Number, std::size_t N>
  void operator()(std::array<Number, N>& values) noexcept {
    for (Number& value : values) (*this)(value);
  }
  [[nodiscard]] std::size_t left() const noexcept { return rest_.size(); }

 private:
  std::span<const std::byte> rest_;
};

/// Puts numbers one after another into bytes, least significant first. The bytes must suffice.
class LittleEndianWriter {
 public:
  explicit LittleEndianWriter(std::span<std::byte> bytes) noexcept : rest_(bytes) {}

  template <std::unsigned_integral Number>
  void operator()(Number value) noexcept {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      rest_[i] = static_cast<std::byte>(value >> (8 * i) & 0xFF);
    rest_ = rest_.subspan(sizeof(Number));
  }
  void operator()(std::int32_t value) noexcept { (*this)(std::bit_cast<std::uint32_t>(value)); }
  void operator()(float value) noexcept { (*this)(std::bit_cast<std::uint32_t>(value)); }
  template <class Number, std::size_t N>
  void operator()(const std::array<Number, N>& values) noexcept {
    for (const Number& value : values) (*this)(value);
  }
  [[nodiscard]] std::size_t left() const noexcept { return rest_.size(); }

 private:
  std::span<std::byte> rest_;
};

}  // namespace mirrorarm::devices
