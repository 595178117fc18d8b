// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>

#include "fantail/bench_log.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"

namespace fantail::tool {
namespace {

/// What is to be typed before the record is erased, after a question that is true of it.
struct Consent {
  std::string question;
  std::string word;
};

Consent consent_of(const LogVisit& visit) {
  if (visit.options.discard || visit.check.intact) {
    return {"Type ERASE to erase the flight record of the rocket, anything else to keep it: ", "ERASE"};
  }
  return {fmt::format("The record is damaged in the flash itself: two downloads agree. Its readable part is in {}. "
                      "Type ERASE DAMAGED to erase the record of the rocket, anything else to keep it: ",
                      visit.options.out),
          "ERASE DAMAGED"};
}

void expect_whole_copy(const LogVisit& visit) {
  if (visit.options.discard) {
    return;
  }
  if (!visit.check.agrees()) {
    throw RequirementNotMet{
        "two downloads of the record differ, so the flight record is kept; give the same command again"};
  }
  if (!visit.check.intact && visit.options.yes) {
    throw RequirementNotMet{
        "the record is damaged in the flash, so --yes does not erase it and the flight record is kept; without --yes, "
        "this program asks"};
  }
}

void await_consent(LogVisit& visit) {
  if (visit.options.yes) {
    return;
  }
  const Consent consent = consent_of(visit);
  say(consent.question);  // standard output may be one JSON object
  LineInput input;
  std::optional<std::string> line;
  while (!(line = input.next())) {
    if (input.ended()) {
      throw RequirementNotMet{consent.word + " was not typed; the flight record is kept"};
    }
    visit.place.wait(hal::Microseconds{50'000});
    visit.link.listen(visit.place.now());
    visit.link.expect_one_rocket();
  }
  if (*line != consent.word) {
    throw RequirementNotMet{"not confirmed; the flight record is kept"};
  }
}

// While somebody thought about the question, another rocket may have come to the cable.
void expect_same_record(LogVisit& visit) {
  const bool same = visit.reader.info().used_bytes == visit.info.used_bytes &&
                    (visit.options.discard || link::still_there(visit.reader, 0, visit.record));
  if (!same) {
    throw RequirementNotMet{
        "the rocket no longer has the record that was downloaded, so nothing is erased; give the same command again"};
  }
}

}  // namespace

void erase_record(LogVisit& visit) {
  expect_whole_copy(visit);
  await_consent(visit);
  expect_same_record(visit);
  try {
    link::Session session{visit.place, visit.link, static_cast<std::uint16_t>(std::random_device{}())};
    Progress progress{"erasing the flight record",
                      {.unit = "bytes", .rate = " a second", .total = static_cast<double>(visit.info.used_bytes)}};
    visit.reader.erase(session, [&](std::uint32_t left) { progress.show(visit.info.used_bytes - left); });
    (void)session.close();
  } catch (const Interrupted&) {
    throw Interrupted{"interrupted; the avionics stops erasing, and the rest of the record is still there"};
  }
  visit.tell("the flight record is erased\n");
}

}  // namespace fantail::tool
