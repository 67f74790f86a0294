#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/records/store.h"

namespace soci {
class session;
}

namespace mirrorarm::records {

/// The statement that makes the table of the measures: a row a finished session, a column a figure.
[[nodiscard]] std::string measuresTable();

void insertMeasures(soci::session& sql, std::int64_t session, const therapy::SessionMeasures& measures);

/// Sessions with their measures, the oldest first; `condition` is SQL on the table session ("true" for all).
[[nodiscard]] std::vector<Session> selectSessions(soci::session& sql, const std::string& condition);

}  // namespace mirrorarm::records
