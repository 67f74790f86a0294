#pragma once

#include <cstdint>
#include <netinet/in.h>
#include <string>

#include "core/common/expected.h"
#include "core/common/time.h"

// What the sockets of this room share.
namespace mirrorarm::devices {

/// The address of a host, by name or number; 127.0.0.1 is 0x7F000001. The error is the reason.
[[nodiscard]] Expected<std::uint32_t, std::string> ipv4Of(const std::string& host);

/// As the system's calls want it.
[[nodiscard]] sockaddr_in socketAddress(std::uint32_t address, std::uint16_t port) noexcept;

/// Whether the socket gets ready for `events` (of poll) within `longest`.
[[nodiscard]] bool readyWithin(int socket, short events, Seconds longest) noexcept;

}  // namespace mirrorarm::devices
