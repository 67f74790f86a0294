#include "core/camera/image_integrity.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/camera/image_header.h"

namespace mirrorarm::camera {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::size_t kPngSignature = 8;
constexpr std::array<std::uint8_t, 2> kJpegScan{0xff, 0xda};
constexpr std::array<std::uint8_t, 2> kJpegEnd{0xff, 0xd9};

std::uint32_t bigEndian(Bytes four) {
  return std::uint32_t{four[0]} << 24 | std::uint32_t{four[1]} << 16 | std::uint32_t{four[2]} << 8 | four[3];
}

constexpr auto kCrcTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}();

std::uint32_t crc32(Bytes bytes) {
  std::uint32_t c = 0xffffffffU;
  for (const auto byte : bytes) c = kCrcTable[(c ^ byte) & 0xff] ^ (c >> 8);
  return ~c;
}

/// Chunk: length, kind, data, checksum over kind and data.
bool isWholePng(Bytes rest) {
  rest = rest.subspan(kPngSignature);
  while (rest.size() >= 12) {
    const std::size_t length = bigEndian(rest.first(4));
    if (length > rest.size() - 12) return false;
    const Bytes body = rest.subspan(4, length + 4);
    if (crc32(body) != bigEndian(rest.subspan(length + 8, 4))) return false;
    if (std::equal(body.begin(), body.begin() + 4, "IEND")) return true;
    rest = rest.subspan(length + 12);
  }
  return false;
}

/// The picture's own end comes after its last scan; a thumbnail's end stands before it.
bool isWholeJpeg(Bytes bytes) {
  const auto scan = std::find_end(bytes.begin(), bytes.end(), kJpegScan.begin(), kJpegScan.end());
  return scan != bytes.end() &&
         std::search(scan, bytes.end(), kJpegEnd.begin(), kJpegEnd.end()) != bytes.end();
}

bool holds(Bytes bytes, std::optional<std::uint64_t> promised) {
  return promised && bytes.size() >= *promised;
}

}  // namespace

bool isWhole(Bytes bytes) {
  const auto format = formatOf(bytes);
  if (format == ImageFormat::kPng) return isWholePng(bytes);
  if (format == ImageFormat::kJpeg) return isWholeJpeg(bytes);
  if (format == ImageFormat::kBmp) return holds(bytes, bmpBytes(bytes));
  if (format == ImageFormat::kGreyMap || format == ImageFormat::kColourMap)
    return holds(bytes, mapBytes(bytes));
  return true;
}

}  // namespace mirrorarm::camera
