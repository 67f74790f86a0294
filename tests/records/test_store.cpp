#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/records/recorded.h"

namespace mirrorarm::records {
namespace {

class StoreTest : public ::testing::Test {
 protected:
  StoreTest() : store_(std::move(*Store::open(folder_.store()))) {
    patient_ = *store_->addPatient({0, "P-0001", "Ada Example", 1961, "left"});
    session_ = *store_->beginSession(anySession(patient_));
  }
  Folder folder_;
  std::unique_ptr<Store> store_;
  std::int64_t patient_ = 0, session_ = 0;
};

void expectEqual(const therapy::Sample& a, const therapy::Sample& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.training, b.training);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.matched, b.matched);
  EXPECT_EQ(a.rms_m, b.rms_m);
  EXPECT_EQ(a.sigma_t_m, b.sigma_t_m);
  EXPECT_EQ(a.sigma_r_rad, b.sigma_r_rad);
  for (auto pose : {&therapy::Sample::X_CT, &therapy::Sample::X_BT, &therapy::Sample::X_BE,
                    &therapy::Sample::X_BE_goal}) {
    EXPECT_EQ((a.*pose).translation(), (b.*pose).translation());
    EXPECT_TRUE((a.*pose).linear().isApprox((b.*pose).linear(), 1e-14));
  }
  EXPECT_EQ(a.force_share, b.force_share);
  EXPECT_EQ(a.help_level, b.help_level);
  EXPECT_EQ(a.help_adapts, b.help_adapts);
  EXPECT_EQ(a.q_rad, b.q_rad);
  EXPECT_EQ(a.v_rad_s, b.v_rad_s);
  EXPECT_EQ(a.a_rad_s2, b.a_rad_s2);
}

TEST_F(StoreTest, PatientsComeBack) {
  const auto patient = store_->patient(patient_);
  ASSERT_TRUE(patient);
  EXPECT_EQ(patient->code, "P-0001");
  EXPECT_EQ(patient->name, "Ada Example");
  EXPECT_EQ(patient->birth_year, 1961);
  EXPECT_EQ(patient->impaired_side, "left");
  EXPECT_EQ(store_->patients()->size(), 1u);
}

TEST_F(StoreTest, SamplesComeBackToTheLastBit) {
  const auto samples = anySamples(60);
  ASSERT_TRUE(store_->addSamples(session_, std::span(samples).first(24)));
  ASSERT_TRUE(store_->addSamples(session_, std::span(samples).subspan(24)));
  const auto read = store_->samples(session_);
  ASSERT_TRUE(read) << read.error().reason;
  ASSERT_EQ(read->size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) expectEqual((*read)[i], samples[i]);
}

TEST_F(StoreTest, AFinishedSessionHasItsMeasures) {
  ASSERT_TRUE(store_->finishSession(session_, "stop.operator", anyMeasures()));
  const auto session = store_->session(session_);
  ASSERT_TRUE(session) << session.error().reason;
  EXPECT_EQ(session->patient_id, patient_);
  EXPECT_EQ(session->started_at, "2026-01-31T09:05:00Z");
  EXPECT_EQ(session->ended_at.size(), 20u);
  EXPECT_EQ(session->exercise, "reach");
  EXPECT_EQ(session->mapping, "mirror");
  EXPECT_EQ(session->end_reason, "stop.operator");
  EXPECT_EQ(session->software, "0.1.0");
  EXPECT_TRUE(session->simulated);
  EXPECT_EQ(session->measures.frames, 960);
  EXPECT_EQ(session->measures.repetitions, 10);
  EXPECT_EQ(session->measures.tracked_share, 0.987);
  EXPECT_EQ(session->measures.lag_ms, 137.25);
  EXPECT_EQ(session->measures.joint_acceleration_ratio, 0.99);
  EXPECT_EQ(session->measures.force_share, 0.43);
  EXPECT_EQ(session->measures.help_level, 0.0);
  EXPECT_EQ(session->measures.help_adapting_share, std::nullopt) << "not known, which is not zero";
}

TEST_F(StoreTest, AnOpenSessionHasNoEndAndNoMeasures) {
  const auto second = store_->beginSession(anySession(patient_));
  ASSERT_TRUE(store_->finishSession(session_, "finished", anyMeasures()));
  const auto sessions = store_->sessions();
  ASSERT_EQ(sessions->size(), 2u);
  EXPECT_EQ((*sessions)[1].id, *second);
  EXPECT_TRUE((*sessions)[1].ended_at.empty());
  EXPECT_EQ((*sessions)[1].measures.frames, 0);
  EXPECT_EQ((*sessions)[1].measures.lag_ms, 0.0);
}

TEST_F(StoreTest, EventsComeBackInOrder) {
  ASSERT_TRUE(store_->addEvent(session_, 1.5, "stop.target_lost"));
  ASSERT_TRUE(store_->addEvent(session_, 2.5, "start"));
  const auto events = store_->events(session_);
  ASSERT_EQ(events->size(), 2u);
  EXPECT_EQ((*events)[0].time_s, 1.5);
  EXPECT_EQ((*events)[0].event, "stop.target_lost");
  EXPECT_EQ((*events)[1].event, "start");
}

TEST_F(StoreTest, WhatIsFinishedStaysAsItIs) {
  ASSERT_TRUE(store_->finishSession(session_, "finished", anyMeasures()));
  EXPECT_EQ(store_->addSamples(session_, anySamples(1)).error().reason, "session 1: is finished");
  EXPECT_FALSE(store_->addEvent(session_, 0.0, "late"));
  EXPECT_FALSE(store_->finishSession(session_, "finished", {}));
  EXPECT_EQ(store_->session(session_)->measures.frames, 960);
}

TEST_F(StoreTest, StrangersAreRefused) {
  EXPECT_EQ(store_->session(99).error().reason, "session 99: is not in the store");
  EXPECT_FALSE(store_->patient(99));
  EXPECT_FALSE(store_->addSamples(99, anySamples(1)));
  EXPECT_FALSE(store_->addEvent(99, 0.0, "x"));
  EXPECT_FALSE(store_->beginSession(anySession(99)));
  EXPECT_TRUE(store_->samples(99)->empty());
}

TEST_F(StoreTest, TheCodeIsUniqueAndTheNameStaysOutOfTheReason) {
  const auto again = store_->addPatient({0, "P-0001", "Bob Secret", 0, ""});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().reason.find("Secret"), std::string::npos);
  EXPECT_NE(again.error().reason.find("patient.code"), std::string::npos);
  EXPECT_FALSE(store_->addPatient({0, "", "", 0, ""}));
  EXPECT_FALSE(store_->addPatient({0, "P-0002", "", 0, "middle"}));
  EXPECT_EQ(store_->patients()->size(), 1u);
}

TEST_F(StoreTest, ABadSampleRefusesItsWholeBatch) {
  auto samples = anySamples(10);
  samples[7].v_rad_s[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(store_->addSamples(session_, samples));
  samples = anySamples(10);
  samples[7].X_BE.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(store_->addSamples(session_, samples));
  samples = anySamples(10);
  samples[7].force_share = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(store_->addSamples(session_, samples));
  EXPECT_TRUE(store_->samples(session_)->empty());
  EXPECT_TRUE(store_->addSamples(session_, anySamples(10)));
}

TEST_F(StoreTest, TextIsTextWhateverItHolds) {
  const std::string name = "Robert'); drop table patient; -- \"\xC3\xA9\xC3\xBC\n:code ?1";
  const auto id = store_->addPatient({0, "P-'2'", name, 0, ""});
  ASSERT_TRUE(id);
  EXPECT_EQ(store_->patient(*id)->name, name);
}

}  // namespace
}  // namespace mirrorarm::records
