#include "core/records/store.h"

#include <algorithm>
#include <stdexcept>

#include <soci/soci.h>

#include "core/common/calendar.h"
#include "core/records/database.h"
#include "core/records/sample_rows.h"
#include "core/records/session_rows.h"

namespace mirrorarm::records {
namespace {

StoreError oneLine(std::string reason) {
  std::ranges::replace(reason, '\n', ' ');
  return {std::move(reason)};
}

/// What `work` gives, or why the database refused. Values never get into the reason: it may end up in a log.
template <class Work>
auto guarded(const std::string& what, const Work& work) -> FromStore<decltype(work())> {
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return {};
    } else {
      return work();
    }
  } catch (const soci::soci_error& error) {
    return unexpected(oneLine(what + ": " + error.get_error_message()));
  } catch (const std::exception& error) {
    return unexpected(oneLine(what + ": " + error.what()));
  }
}

/// All or nothing. Takes the write lock at once: a transaction that read first could not wait for another
/// writer.
class WriteTransaction {
 public:
  explicit WriteTransaction(soci::session& sql) : sql_(sql) { sql_ << "begin immediate"; }
  ~WriteTransaction() {
    if (is_done_) return;
    try {
      sql_ << "rollback";
    } catch (const std::exception&) {
      // SQLite has rolled back by itself; the first error is the one that is told.
    }
  }
  WriteTransaction(const WriteTransaction&) = delete;
  WriteTransaction& operator=(const WriteTransaction&) = delete;
  void commit() {
    sql_ << "commit";
    is_done_ = true;
  }

 private:
  soci::session& sql_;
  bool is_done_ = false;
};

std::string nameOf(std::int64_t session) { return "session " + std::to_string(session); }

/// What is recorded stays as it is once the session is finished.
void requireOpen(soci::session& sql, std::int64_t session) {
  const long long id = session;
  std::string ended_at;
  sql << "select ended_at from session where id = :id", soci::use(id), soci::into(ended_at);
  if (!sql.got_data()) throw std::runtime_error("is not in the store");
  if (!ended_at.empty()) throw std::runtime_error("is finished");
}

/// Patients that meet `condition` (SQL on the table patient), in the order of adding.
std::vector<Patient> selectPatients(soci::session& sql, const std::string& condition) {
  long long id = 0;
  Patient patient;
  soci::statement select =
      (sql.prepare << "select id, code, name, birth_year, impaired_side from patient where " << condition
                   << " order by id",
       soci::into(id), soci::into(patient.code), soci::into(patient.name), soci::into(patient.birth_year),
       soci::into(patient.impaired_side));
  select.execute();
  std::vector<Patient> patients;
  while (select.fetch()) {
    patient.id = id;
    patients.push_back(patient);
  }
  return patients;
}

std::int64_t lastId(soci::session& sql, const std::string& table) {
  long long id = 0;
  if (!sql.get_last_insert_id(table, id)) throw std::runtime_error("gave no id");
  return id;
}

}  // namespace

struct Store::Body {
  std::unique_ptr<soci::session> sql;
};

Store::Store(std::unique_ptr<Body> body) : body_(std::move(body)) {}
Store::~Store() = default;

FromStore<std::unique_ptr<Store>> Store::open(const std::filesystem::path& file) {
  return guarded(file.string(), [&] {
    return std::unique_ptr<Store>(new Store(std::make_unique<Body>(openDatabase(file, WhenMissing::kMake))));
  });
}

FromStore<std::unique_ptr<Store>> Store::openExisting(const std::filesystem::path& file) {
  return guarded(file.string(), [&] {
    return std::unique_ptr<Store>(
        new Store(std::make_unique<Body>(openDatabase(file, WhenMissing::kRefuse))));
  });
}

FromStore<std::int64_t> Store::addPatient(const Patient& patient) {
  return guarded("new patient", [&] {
    auto& sql = *body_->sql;
    WriteTransaction transaction(sql);
    sql << "insert into patient (code, name, birth_year, impaired_side) values (:code, :name, :year, :side)",
        soci::use(patient.code), soci::use(patient.name), soci::use(patient.birth_year),
        soci::use(patient.impaired_side);
    const auto id = lastId(sql, "patient");
    transaction.commit();
    return id;
  });
}

FromStore<std::vector<Patient>> Store::patients() {
  return guarded("patients", [&] { return selectPatients(*body_->sql, "true"); });
}

FromStore<Patient> Store::patient(std::int64_t id) {
  return guarded("patient " + std::to_string(id), [&] {
    const auto found = selectPatients(*body_->sql, "id = " + std::to_string(id));
    if (found.empty()) throw std::runtime_error("is not in the store");
    return found.front();
  });
}

FromStore<std::int64_t> Store::beginSession(const Session& session) {
  return guarded("new session", [&] {
    auto& sql = *body_->sql;
    const long long patient_id = session.patient_id;
    const std::string started_at = session.started_at.empty() ? isoUtcNow() : session.started_at;
    const int simulated = session.simulated ? 1 : 0;
    WriteTransaction transaction(sql);
    sql << "insert into session (patient_id, started_at, ended_at, exercise, mapping, end_reason, software, "
           "simulated) values (:patient, :started_at, '', :exercise, :mapping, '', :software, :simulated)",
        soci::use(patient_id), soci::use(started_at), soci::use(session.exercise), soci::use(session.mapping),
        soci::use(session.software), soci::use(simulated);
    const auto id = lastId(sql, "session");
    transaction.commit();
    return id;
  });
}

FromStore<void> Store::addSamples(std::int64_t session, std::span<const therapy::Sample> samples) {
  return guarded(nameOf(session), [&] {
    WriteTransaction transaction(*body_->sql);
    requireOpen(*body_->sql, session);
    insertSamples(*body_->sql, session, samples);
    transaction.commit();
  });
}

FromStore<void> Store::addEvent(std::int64_t session, double time_s, const std::string& event) {
  return guarded(nameOf(session), [&] {
    auto& sql = *body_->sql;
    const long long id = session;
    WriteTransaction transaction(sql);
    requireOpen(sql, session);
    sql << "insert into event (session_id, time_s, event) values (:id, :time_s, :event)", soci::use(id),
        soci::use(time_s), soci::use(event);
    transaction.commit();
  });
}

FromStore<void> Store::finishSession(std::int64_t session, const std::string& end_reason,
                                     const therapy::SessionMeasures& measures) {
  return guarded(nameOf(session), [&] {
    auto& sql = *body_->sql;
    const long long id = session;
    const std::string ended_at = isoUtcNow();
    WriteTransaction transaction(sql);
    requireOpen(sql, session);
    insertMeasures(sql, session, measures);
    sql << "update session set ended_at = :ended_at, end_reason = :end_reason where id = :id",
        soci::use(ended_at), soci::use(end_reason), soci::use(id);
    transaction.commit();
  });
}

FromStore<std::vector<Session>> Store::sessions() {
  return guarded("sessions", [&] { return selectSessions(*body_->sql, "true"); });
}

FromStore<Session> Store::session(std::int64_t id) {
  return guarded(nameOf(id), [&] {
    const auto found = selectSessions(*body_->sql, "session.id = " + std::to_string(id));
    if (found.empty()) throw std::runtime_error("is not in the store");
    return found.front();
  });
}

FromStore<std::vector<therapy::Sample>> Store::samples(std::int64_t session) {
  return guarded(nameOf(session), [&] { return selectSamples(*body_->sql, session); });
}

FromStore<std::vector<Store::Event>> Store::events(std::int64_t session) {
  return guarded(nameOf(session), [&] {
    const long long id = session;
    Event event;
    soci::statement select = (body_->sql->prepare << "select time_s, event from event where session_id = :id "
                                                     "order by id",
                              soci::use(id), soci::into(event.time_s), soci::into(event.event));
    select.execute();
    std::vector<Event> events;
    while (select.fetch()) events.push_back(event);
    return events;
  });
}

}  // namespace mirrorarm::records
