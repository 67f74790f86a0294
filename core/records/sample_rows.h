#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/therapy/session_measures.h"

namespace soci {
class session;
}

namespace mirrorarm::records {

/// The statement that makes the table of the samples: poses as seven numbers, joints as JSON arrays.
[[nodiscard]] std::string sampleTable();

/// Adds the samples behind those that are there. Throws std::runtime_error for numbers that are not finite.
void insertSamples(soci::session& sql, std::int64_t session, std::span<const therapy::Sample> samples);

/// In the order of adding. Throws std::runtime_error where a row is damaged.
[[nodiscard]] std::vector<therapy::Sample> selectSamples(soci::session& sql, std::int64_t session);

}  // namespace mirrorarm::records
