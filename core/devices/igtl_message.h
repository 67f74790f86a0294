#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/common/expected.h"

namespace mirrorarm::devices {

/// One message of the OpenIGTLink protocol, versions 1 to 3, its body checked against its checksum.
/// Source: Tokuda et al., Int. J. Medical Robotics 5(4), 2009; openigtlink.org, protocol version 3.
struct IgtlMessage {
  std::string type;                ///< "TRANSFORM", "TDATA", ..
  std::string device;              ///< the sender's name for it
  double time_s = 0.0;             ///< UTC by the sender's clock; 0 where it gives none
  std::vector<std::byte> content;  ///< without the extended header and metadata of version 2 and up
};

/// Why a stream is not to be trusted any more.
enum class IgtlFault : std::uint8_t {
  kBadHeader,  ///< an unknown version, or a name that is no text: out of step
  kTooLarge,   ///< a body of more than kMostBody bytes
  kBadChecksum,
  kBadBody,  ///< an extended header that does not fit its message
};
[[nodiscard]] std::string_view reason(IgtlFault fault);

inline constexpr std::uint16_t kIgtlPort = 18944;  ///< where servers of the protocol listen
inline constexpr std::size_t kIgtlHeaderSize = 58;
inline constexpr std::size_t kMostBody = std::size_t{1} << 20;

/// A message where it lies, without a copy: good as long as its bytes are.
struct IgtlView {
  std::string_view type;
  std::string_view device;
  double time_s = 0.0;
  std::span<const std::byte> content;
  std::size_t size = 0;  ///< of the whole message in bytes
};
/// The message that `bytes` begin with; nothing when more of them are needed. Does not allocate.
[[nodiscard]] Expected<std::optional<IgtlView>, IgtlFault> igtlView(
    std::span<const std::byte> bytes) noexcept;

/// Puts a message of version 1 into `bytes`, which have room, and returns it. Does not allocate.
std::span<const std::byte> encodeIgtl(std::string_view type, std::string_view device, double time_s,
                                      std::span<const std::byte> content,
                                      std::span<std::byte> bytes) noexcept;

/// CRC-64 of ECMA-182, as the protocol's bodies carry it.
[[nodiscard]] std::uint64_t crc64(std::span<const std::byte> bytes);

/// Cuts a stream of bytes into messages, however the network has split them. After a fault nothing more comes
/// out: the connection is to be closed. One thread.
class IgtlStream {
 public:
  void add(std::span<const std::byte> bytes);
  /// The next whole message; nothing when more bytes are needed.
  [[nodiscard]] Expected<std::optional<IgtlMessage>, IgtlFault> next();

 private:
  std::vector<std::byte> bytes_;
  std::optional<IgtlFault> fault_;
};

/// A message of version 1, as it goes over the wire.
[[nodiscard]] std::vector<std::byte> igtlBytes(const IgtlMessage& message);

}  // namespace mirrorarm::devices
