#include "core/devices/igtl_message.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/devices/big_endian.h"

namespace mirrorarm::devices {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kTypeAt = 2, kTypeSize = 12, kDeviceAt = 14, kDeviceSize = 20, kTimeAt = 34,
                      kBodySizeAt = 42, kChecksumAt = 50;
constexpr std::uint16_t kNewestVersion = 3;
constexpr std::size_t kExtendedHeaderSize = 12;
constexpr double kFraction = 4294967296.0;  // the time stamp's second half counts 2^-32 s

constexpr std::array<std::uint64_t, 256> makeTable() {
  constexpr std::uint64_t kPolynomial = 0x42F0E1EBA9EA3693u;
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t i = 0; i < table.size(); ++i) {
    std::uint64_t remainder = i << 56;
    for (int bit = 0; bit < 8; ++bit) remainder = remainder << 1 ^ (remainder >> 63 != 0 ? kPolynomial : 0);
    table[i] = remainder;
  }
  return table;
}

/// Text of a field that zeros fill up; nothing when it holds what is no printable ASCII.
std::optional<std::string_view> textOf(Bytes field) {
  const auto isPrintable = [](std::byte byte) { return byte >= std::byte{' '} && byte <= std::byte{'~'}; };
  const auto end = std::find(field.begin(), field.end(), std::byte{0});
  if (!std::all_of(field.begin(), end, isPrintable)) return std::nullopt;
  return std::string_view(reinterpret_cast<const char*>(field.data()),
                          static_cast<std::size_t>(end - field.begin()));
}

/// What lies between the extended header and the metadata; nothing when the sizes do not fit.
std::optional<Bytes> contentOf(Bytes body, std::uint16_t version) {
  if (version < 2) return body;
  if (body.size() < kExtendedHeaderSize) return std::nullopt;
  const std::size_t begin = bigEndian<std::uint16_t>(body);
  const std::size_t behind =
      std::size_t{bigEndian<std::uint16_t>(body.subspan(2))} + bigEndian<std::uint32_t>(body.subspan(4));
  if (begin < kExtendedHeaderSize || begin + behind > body.size()) return std::nullopt;
  return body.subspan(begin, body.size() - begin - behind);
}

/// A header's text, cut where it is too long.
void putText(std::string_view text, std::span<std::byte> field) {
  std::fill(field.begin(), field.end(), std::byte{0});
  for (std::size_t i = 0; i < std::min(text.size(), field.size()); ++i)
    field[i] = static_cast<std::byte>(text[i]);
}

}  // namespace

std::string_view reason(IgtlFault fault) {
  switch (fault) {
    case IgtlFault::kBadHeader:
      return "sends what is no header of OpenIGTLink: check host and port";
    case IgtlFault::kTooLarge:
      return "sends a message of more than a megabyte where poses are expected";
    case IgtlFault::kBadChecksum:
      return "sends a message whose checksum is wrong";
    case IgtlFault::kBadBody:
      return "sends a message whose parts do not fit its size";
  }
  return "is refused";
}

std::uint64_t crc64(Bytes bytes) {
  static constexpr auto kTable = makeTable();
  std::uint64_t crc = 0;
  for (const std::byte byte : bytes)
    crc = kTable[(crc >> 56 ^ std::to_integer<std::uint64_t>(byte)) & 0xFF] ^ crc << 8;
  return crc;
}

Expected<std::optional<IgtlView>, IgtlFault> igtlView(Bytes bytes) noexcept {
  if (bytes.size() < kIgtlHeaderSize) return std::nullopt;
  const auto version = bigEndian<std::uint16_t>(bytes);
  const auto type = textOf(bytes.subspan(kTypeAt, kTypeSize));
  const auto device = textOf(bytes.subspan(kDeviceAt, kDeviceSize));
  if (version < 1 || version > kNewestVersion || !type || type->empty() || !device)
    return unexpected(IgtlFault::kBadHeader);
  const auto body_size = bigEndian<std::uint64_t>(bytes.subspan(kBodySizeAt));
  if (body_size > kMostBody) return unexpected(IgtlFault::kTooLarge);
  const std::size_t size = kIgtlHeaderSize + static_cast<std::size_t>(body_size);
  if (bytes.size() < size) return std::nullopt;
  const Bytes body = bytes.subspan(kIgtlHeaderSize, size - kIgtlHeaderSize);
  if (crc64(body) != bigEndian<std::uint64_t>(bytes.subspan(kChecksumAt)))
    return unexpected(IgtlFault::kBadChecksum);
  const auto content = contentOf(body, version);
  if (!content) return unexpected(IgtlFault::kBadBody);
  const double time_s = bigEndian<std::uint32_t>(bytes.subspan(kTimeAt)) +
                        bigEndian<std::uint32_t>(bytes.subspan(kTimeAt + 4)) / kFraction;
  return IgtlView{*type, *device, time_s, *content, size};
}

Bytes encodeIgtl(std::string_view type, std::string_view device, double time_s, Bytes content,
                 std::span<std::byte> bytes) noexcept {
  const double whole_s = std::floor(time_s);
  putBigEndian<std::uint16_t>(1, bytes);
  putText(type, bytes.subspan(kTypeAt, kTypeSize));
  putText(device, bytes.subspan(kDeviceAt, kDeviceSize));
  putBigEndian(static_cast<std::uint32_t>(whole_s), bytes.subspan(kTimeAt));
  putBigEndian(static_cast<std::uint32_t>((time_s - whole_s) * kFraction), bytes.subspan(kTimeAt + 4));
  putBigEndian<std::uint64_t>(content.size(), bytes.subspan(kBodySizeAt));
  putBigEndian(crc64(content), bytes.subspan(kChecksumAt));
  std::copy(content.begin(), content.end(), bytes.begin() + kIgtlHeaderSize);
  return bytes.first(kIgtlHeaderSize + content.size());
}

void IgtlStream::add(Bytes bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

Expected<std::optional<IgtlMessage>, IgtlFault> IgtlStream::next() {
  if (fault_) return unexpected(*fault_);
  const auto view = igtlView(bytes_);
  if (!view) {
    fault_ = view.error();
    return unexpected(*fault_);
  }
  if (!*view) return std::nullopt;
  IgtlMessage message{std::string((*view)->type),
                      std::string((*view)->device),
                      (*view)->time_s,
                      {(*view)->content.begin(), (*view)->content.end()}};
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>((*view)->size));
  return message;
}

std::vector<std::byte> igtlBytes(const IgtlMessage& message) {
  std::vector<std::byte> bytes(kIgtlHeaderSize + message.content.size());
  encodeIgtl(message.type, message.device, message.time_s, message.content, bytes);
  return bytes;
}

}  // namespace mirrorarm::devices
