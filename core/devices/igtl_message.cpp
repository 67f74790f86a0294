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

std::array<std::uint64_t, 256> makeTable() {
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
std::optional<std::string> textOf(Bytes field) {
  std::string text;
  for (const std::byte byte : field) {
    const auto c = std::to_integer<unsigned char>(byte);
    if (c == 0) break;
    if (c < ' ' || c > '~') return std::nullopt;
    text.push_back(static_cast<char>(c));
  }
  return text;
}

struct Header {
  std::uint16_t version = 0;
  IgtlMessage message;
  std::uint64_t body_size = 0;
  std::uint64_t checksum = 0;
};

std::optional<Header> headerOf(Bytes bytes) {
  Header header;
  header.version = bigEndian<std::uint16_t>(bytes);
  const auto type = textOf(bytes.subspan(kTypeAt, kTypeSize));
  const auto device = textOf(bytes.subspan(kDeviceAt, kDeviceSize));
  if (header.version < 1 || header.version > kNewestVersion || !type || type->empty() || !device)
    return std::nullopt;
  header.message.type = *type;
  header.message.device = *device;
  header.message.time_s = bigEndian<std::uint32_t>(bytes.subspan(kTimeAt)) +
                          bigEndian<std::uint32_t>(bytes.subspan(kTimeAt + 4)) / kFraction;
  header.body_size = bigEndian<std::uint64_t>(bytes.subspan(kBodySizeAt));
  header.checksum = bigEndian<std::uint64_t>(bytes.subspan(kChecksumAt));
  return header;
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

void appendText(std::vector<std::byte>& bytes, const std::string& text, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    bytes.push_back(i < text.size() ? static_cast<std::byte>(text[i]) : std::byte{0});
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
  static const auto kTable = makeTable();
  std::uint64_t crc = 0;
  for (const std::byte byte : bytes)
    crc = kTable[(crc >> 56 ^ std::to_integer<std::uint64_t>(byte)) & 0xFF] ^ crc << 8;
  return crc;
}

void IgtlStream::add(Bytes bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

Expected<std::optional<IgtlMessage>, IgtlFault> IgtlStream::next() {
  const auto refuse = [this](IgtlFault fault) {
    fault_ = fault;
    return unexpected(fault);
  };
  if (fault_) return unexpected(*fault_);
  if (bytes_.size() < kIgtlHeaderSize) return std::nullopt;
  auto header = headerOf(bytes_);
  if (!header) return refuse(IgtlFault::kBadHeader);
  if (header->body_size > kMostBody) return refuse(IgtlFault::kTooLarge);
  const std::size_t size = kIgtlHeaderSize + static_cast<std::size_t>(header->body_size);
  if (bytes_.size() < size) return std::nullopt;
  const Bytes body = Bytes(bytes_).subspan(kIgtlHeaderSize, size - kIgtlHeaderSize);
  if (crc64(body) != header->checksum) return refuse(IgtlFault::kBadChecksum);
  const auto content = contentOf(body, header->version);
  if (!content) return refuse(IgtlFault::kBadBody);
  header->message.content.assign(content->begin(), content->end());
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
  return std::move(header->message);
}

std::vector<std::byte> igtlBytes(const IgtlMessage& message) {
  std::vector<std::byte> bytes;
  appendBigEndian<std::uint16_t>(bytes, 1);
  appendText(bytes, message.type, kTypeSize);
  appendText(bytes, message.device, kDeviceSize);
  const double whole_s = std::floor(message.time_s);
  appendBigEndian(bytes, static_cast<std::uint32_t>(whole_s));
  appendBigEndian(bytes, static_cast<std::uint32_t>((message.time_s - whole_s) * kFraction));
  appendBigEndian<std::uint64_t>(bytes, message.content.size());
  appendBigEndian(bytes, crc64(message.content));
  bytes.insert(bytes.end(), message.content.begin(), message.content.end());
  return bytes;
}

}  // namespace mirrorarm::devices
