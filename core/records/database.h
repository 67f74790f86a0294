#pragma once

#include <filesystem>
#include <memory>

namespace soci {
class session;
}

namespace mirrorarm::records {

enum class WhenMissing { kMake, kRefuse };

/// A connection to the store in `file`, its version checked, foreign keys on, write-ahead log, flushed to the
/// disc at every commit. A foreign file is told by its first bytes and left untouched. Throws
/// std::runtime_error or soci::soci_error with the reason.
[[nodiscard]] std::unique_ptr<soci::session> openDatabase(const std::filesystem::path& file,
                                                          WhenMissing missing);

}  // namespace mirrorarm::records
