#pragma once

#include <cstdint>

namespace soci {
class session;
}

namespace mirrorarm::records {

/// "mARM", in the header of every SQLite file of ours (bytes 68 to 71): tells it from other programs' files.
inline constexpr std::uint32_t kApplicationId = 0x6D41524D;

/// Version of the tables below; docs/store.md describes them.
inline constexpr int kSchemaVersion = 2;

/// Makes the tables in an empty database, all or none. Another process that did so in the meantime is no
/// error.
void makeSchema(soci::session& sql);

/// Brings the tables of an older version up to this one, all or none; what is recorded stays as it is.
void migrateSchema(soci::session& sql);

/// The version of the tables that are there.
[[nodiscard]] int schemaVersion(soci::session& sql);

}  // namespace mirrorarm::records
