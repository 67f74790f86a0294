#pragma once

#include <tl/expected.hpp>

namespace mirrorarm {

/// A value, or the reason why there is none. For what the operator can mend; bugs are assertions,
/// a broken world (device, disc) is an exception at the rim.
template <class T, class E>
using Expected = tl::expected<T, E>;

/// `return unexpected(Reason::kTooFew);`
template <class E>
[[nodiscard]] constexpr auto unexpected(E&& error) {
  return tl::make_unexpected(std::forward<E>(error));
}

}  // namespace mirrorarm
