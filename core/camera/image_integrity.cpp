#include "core/camera/image_integrity.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace mirrorarm::camera {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::array<std::uint8_t, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 2> kJpeg{0xff, 0xd8};
constexpr std::array<std::uint8_t, 2> kBmp{'B', 'M'};
constexpr std::array<std::uint8_t, 2> kGreyMap{'P', '5'};
constexpr std::array<std::uint8_t, 2> kColourMap{'P', '6'};
constexpr std::array<std::uint8_t, 2> kJpegScan{0xff, 0xda};
constexpr std::array<std::uint8_t, 2> kJpegEnd{0xff, 0xd9};

template <std::size_t N>
bool startsWith(Bytes bytes, const std::array<std::uint8_t, N>& magic) {
  return bytes.size() >= N && std::equal(magic.begin(), magic.end(), bytes.begin());
}

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
  rest = rest.subspan(kPng.size());
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

bool isWholeBmp(Bytes bytes) {
  if (bytes.size() < 6) return false;
  const auto promised =
      std::uint32_t{bytes[5]} << 24 | std::uint32_t{bytes[4]} << 16 | std::uint32_t{bytes[3]} << 8 | bytes[2];
  return bytes.size() >= promised;
}

/// The next number of a PGM/PPM header, `rest` moved behind it; comments run from # to the line's end.
std::optional<std::size_t> headerNumber(Bytes& rest) {
  while (!rest.empty() && (std::isspace(rest[0]) != 0 || rest[0] == '#')) {
    const bool comment = rest[0] == '#';
    do rest = rest.subspan(1);
    while (comment && !rest.empty() && rest[0] != '\n');
  }
  std::size_t number = 0;
  std::size_t digits = 0;
  for (; digits < rest.size() && digits < 7 && std::isdigit(rest[digits]) != 0; ++digits)
    number = 10 * number + (rest[digits] - '0');
  rest = rest.subspan(digits);
  return digits > 0 ? std::optional(number) : std::nullopt;
}

bool isWholeMap(Bytes bytes, std::size_t channels) {
  Bytes rest = bytes.subspan(2);
  const auto width = headerNumber(rest);
  const auto height = headerNumber(rest);
  const auto brightest = headerNumber(rest);
  if (!width || !height || !brightest) return false;
  const std::size_t depth = *brightest > 255 ? 2 : 1;
  return rest.size() >= 1 + *width * *height * channels * depth;
}

}  // namespace

bool isWhole(Bytes bytes) {
  if (startsWith(bytes, kPng)) return isWholePng(bytes);
  if (startsWith(bytes, kJpeg)) return isWholeJpeg(bytes);
  if (startsWith(bytes, kBmp)) return isWholeBmp(bytes);
  if (startsWith(bytes, kGreyMap)) return isWholeMap(bytes, 1);
  if (startsWith(bytes, kColourMap)) return isWholeMap(bytes, 3);
  return true;
}

}  // namespace mirrorarm::camera
