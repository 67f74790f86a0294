#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "core/peers/fri_fault.h"

namespace mirrorarm::peers {

using Datagram = std::vector<std::byte>;

/// One direction of a line on which datagrams of FRI suffer the faults that are active: the same ones for the
/// same seed. One thread.
class FaultyWire {
 public:
  /// Heeds the faults of datagrams that are meant for its direction.
  FaultyWire(std::span<const FriFault> faults, bool carries_answers, std::uint64_t seed);

  /// Puts a datagram in at `time_s`.
  void put(std::span<const std::byte> bytes, double time_s);
  /// What comes out now. Good until the next call of either.
  [[nodiscard]] std::span<const Datagram> take();
  /// A cycle is over: what is late comes nearer.
  void endCycle();

 private:
  struct Delayed {
    int cycles = 0;           ///< until it comes out
    bool after_next = false;  ///< or behind the next datagram
    Datagram bytes;
  };
  [[nodiscard]] bool happens(const FriFault& fault, double time_s);
  void spoil(FriFaultKind kind, Datagram& bytes);

  std::vector<FriFault> faults_;
  bool carries_answers_;
  std::mt19937_64 random_;
  std::vector<Delayed> delayed_;
  std::vector<Datagram> ready_, taken_;
};

}  // namespace mirrorarm::peers
