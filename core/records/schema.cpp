#include "core/records/schema.h"

#include <array>
#include <string>

#include <soci/soci.h>

#include "core/common/calendar.h"
#include "core/records/sample_rows.h"
#include "core/records/session_rows.h"

namespace mirrorarm::records {
namespace {

constexpr const char* kStoreTable =
    "create table store (version integer not null, made_at text not null, software text not null)";
constexpr const char* kPatientTable =
    "create table patient (id integer primary key autoincrement, code text not null unique check (code <> "
    "''), "
    "name text not null, birth_year integer not null, "
    "impaired_side text not null check (impaired_side in ('', 'left', 'right')))";
constexpr const char* kSessionTable =
    "create table session (id integer primary key autoincrement, "
    "patient_id integer not null references patient (id), started_at text not null, ended_at text not null, "
    "exercise text not null, mapping text not null, end_reason text not null, software text not null, "
    "simulated integer not null)";
constexpr const char* kEventTable =
    "create table event (id integer primary key autoincrement, "
    "session_id integer not null references session (id), time_s real not null, event text not null)";

/// What version 2 has and version 1 had not: force at the sling and help.
constexpr std::array kSinceVersion2{"alter table session_measures add column force_share real",
                                    "alter table session_measures add column help_level real",
                                    "alter table session_measures add column help_adapting_share real",
                                    "alter table sample add column force_share real",
                                    "alter table sample add column help_level real",
                                    "alter table sample add column help_adapts integer not null default 0",
                                    "update store set version = 2"};

bool isMade(soci::session& sql) {
  int tables = 0;
  sql << "select count(*) from sqlite_master where type = 'table' and name = 'store'", soci::into(tables);
  return tables == 1;
}

}  // namespace

void makeSchema(soci::session& sql) {
  soci::transaction transaction(sql);
  // A write comes first, so that of two processes one waits here.
  sql << "pragma application_id = " << kApplicationId;
  if (!isMade(sql)) {
    for (const std::string& table :
         {std::string(kStoreTable), std::string(kPatientTable), std::string(kSessionTable), measuresTable(),
          sampleTable(), std::string(kEventTable)})
      sql << table;
    sql << "create index session_of_patient on session (patient_id)";
    sql << "create index sample_of_session on sample (session_id)";
    sql << "create index event_of_session on event (session_id)";
    const std::string made_at = isoUtcNow(), software = MIRRORARM_VERSION;
    sql << "insert into store (version, made_at, software) values (:version, :made_at, :software)",
        soci::use(kSchemaVersion), soci::use(made_at), soci::use(software);
  }
  transaction.commit();
}

int schemaVersion(soci::session& sql) {
  int version = 0;
  sql << "select version from store", soci::into(version);
  return version;
}

void migrateSchema(soci::session& sql) {
  if (schemaVersion(sql) != 1) return;
  soci::transaction transaction(sql);
  // A write comes first, so that of two processes one waits here and then finds the work done.
  sql << "pragma application_id = " << kApplicationId;
  if (schemaVersion(sql) == 1)
    for (const char* change : kSinceVersion2) sql << change;
  transaction.commit();
}

}  // namespace mirrorarm::records
