#include "core/camera/image_header.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace mirrorarm::camera {
namespace {

using Bytes = std::span<const std::uint8_t>;
using namespace std::string_view_literals;

bool startsWith(Bytes bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char letter, std::uint8_t byte) { return static_cast<std::uint8_t>(letter) == byte; });
}

enum class Order { kLittle, kBig };

/// `count` bytes from `offset` as a number; the caller knows that they are there.
std::uint32_t number(Bytes bytes, std::size_t offset, std::size_t count, Order order) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value = value << 8 | bytes[offset + (order == Order::kBig ? i : count - 1 - i)];
  return value;
}

std::uint32_t little(Bytes bytes, std::size_t offset, std::size_t count) {
  return number(bytes, offset, count, Order::kLittle);
}

constexpr std::size_t kBmpHeader = 34;
constexpr std::uint32_t kBmpCoreHeader = 12;  // of OS/2, with 16-bit sides

std::optional<PromisedSize> bmpSize(Bytes bytes) {
  if (bytes.size() < kBmpHeader) return std::nullopt;
  if (little(bytes, 14, 4) == kBmpCoreHeader) return PromisedSize{little(bytes, 18, 2), little(bytes, 20, 2)};
  const auto height = static_cast<std::int32_t>(little(bytes, 22, 4));  // negative: the upper row first
  return PromisedSize{little(bytes, 18, 4), static_cast<std::uint64_t>(std::abs(std::int64_t{height}))};
}

std::optional<PromisedSize> pngSize(Bytes bytes) {
  if (bytes.size() < 24) return std::nullopt;
  return PromisedSize{number(bytes, 16, 4, Order::kBig), number(bytes, 20, 4, Order::kBig)};
}

/// From the first directory: tags 256 and 257, each 16 or 32 bits wide.
std::optional<PromisedSize> tiffSize(Bytes bytes) {
  const Order order = bytes[0] == 'I' ? Order::kLittle : Order::kBig;
  if (bytes.size() < 8) return std::nullopt;
  const std::size_t directory = number(bytes, 4, 4, order);
  if (directory + 2 > bytes.size()) return std::nullopt;
  const std::size_t entries = number(bytes, directory, 2, order);
  if (directory + 2 + 12 * entries > bytes.size()) return std::nullopt;
  PromisedSize size;
  for (std::size_t at = directory + 2; at < directory + 2 + 12 * entries; at += 12) {
    const auto value = number(bytes, at + 8, number(bytes, at + 2, 2, order) == 3 ? 2 : 4, order);
    const auto tag = number(bytes, at, 2, order);
    if (tag == 256) size.width_px = value;
    if (tag == 257) size.height_px = value;
  }
  return size;
}

/// The next number of a PGM/PPM header, `rest` moved behind it; comments run from # to the line's end.
std::optional<std::uint64_t> headerNumber(Bytes& rest) {
  while (!rest.empty() && (std::isspace(rest[0]) != 0 || rest[0] == '#')) {
    const bool comment = rest[0] == '#';
    do rest = rest.subspan(1);
    while (comment && !rest.empty() && rest[0] != '\n');
  }
  std::uint64_t value = 0;
  std::size_t digits = 0;
  for (; digits < rest.size() && digits < 7 && std::isdigit(rest[digits]) != 0; ++digits)
    value = 10 * value + (rest[digits] - '0');
  rest = rest.subspan(digits);
  return digits > 0 ? std::optional(value) : std::nullopt;
}

std::optional<PromisedSize> mapSize(Bytes bytes) {
  Bytes rest = bytes.subspan(2);
  const auto width = headerNumber(rest);
  const auto height = headerNumber(rest);
  if (!width || !height) return std::nullopt;
  return PromisedSize{*width, *height};
}

}  // namespace

std::optional<ImageFormat> formatOf(Bytes bytes) {
  if (startsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return ImageFormat::kPng;
  if (startsWith(bytes, "\xff\xd8"sv)) return ImageFormat::kJpeg;
  if (startsWith(bytes, "BM"sv)) return ImageFormat::kBmp;
  if (startsWith(bytes, "II*\0"sv) || startsWith(bytes, "MM\0*"sv)) return ImageFormat::kTiff;
  if (startsWith(bytes, "P5"sv)) return ImageFormat::kGreyMap;
  if (startsWith(bytes, "P6"sv)) return ImageFormat::kColourMap;
  return std::nullopt;
}

std::optional<PromisedSize> promisedSize(Bytes bytes) {
  const auto format = formatOf(bytes);
  if (format == ImageFormat::kPng) return pngSize(bytes);
  if (format == ImageFormat::kBmp) return bmpSize(bytes);
  if (format == ImageFormat::kTiff) return tiffSize(bytes);
  if (format == ImageFormat::kGreyMap || format == ImageFormat::kColourMap) return mapSize(bytes);
  return std::nullopt;
}

std::optional<std::uint64_t> mapBytes(Bytes bytes) {
  Bytes rest = bytes.subspan(2);
  const auto width = headerNumber(rest);
  const auto height = headerNumber(rest);
  const auto brightest = headerNumber(rest);
  if (!width || !height || !brightest) return std::nullopt;
  const std::uint64_t depth = *brightest > 255 ? 2 : 1;
  const std::uint64_t channels = formatOf(bytes) == ImageFormat::kColourMap ? 3 : 1;
  return bytes.size() - rest.size() + 1 + *width * *height * channels * depth;
}

std::optional<std::uint64_t> bmpBytes(Bytes bytes) {
  const auto size = bmpSize(bytes);
  if (!size) return std::nullopt;
  const std::uint64_t stated = little(bytes, 2, 4);
  const bool core = little(bytes, 14, 4) == kBmpCoreHeader;
  if (core || little(bytes, 30, 4) != 0) return stated;
  const std::uint64_t row = (size->width_px * little(bytes, 28, 2) + 31) / 32 * 4;
  return std::max(stated, little(bytes, 10, 4) + row * size->height_px);
}

}  // namespace mirrorarm::camera
