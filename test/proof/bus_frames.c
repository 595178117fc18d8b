// SPDX-License-Identifier: MIT
// The generated C code that unpacks the six messages which a bench may send, given any bytes, and any number of them up
// to eight: it reads none beyond the last one, refuses fewer than eight, and what it makes of the four angles of a
// request is within 20.48 degrees, and within 20.47 where it says that it is in range. Packed again, a message whose
// unused bits were zero gives the same bytes.
#include <stdlib.h>

#include "protocol/generated/canard_bus.c"

_Bool nondet_bool(void);
uint8_t nondet_u8(void);
void __ESBMC_assume(_Bool);
void __ESBMC_assert(_Bool, const char*);

#ifdef PROOF_REACHABLE
#define CLAIM(condition) ((void)0)
#define REACHABLE(number, condition) \
  if ((number) == PROOF_REACHABLE) __ESBMC_assert(!(condition), "reached")
#else
#define CLAIM(condition) __ESBMC_assert(condition, "claim: " #condition)
#define REACHABLE(number, condition) ((void)0)
#endif

static void claim_angle(int16_t raw) {
  const float degrees = canard_bus_bench_request_canard_1_decode(raw);
  CLAIM(degrees >= -20.4801F && degrees <= 20.4701F);
  CLAIM(!canard_bus_bench_request_canard_1_is_in_range(raw) || (degrees >= -20.4701F && degrees <= 20.4701F));
}

int main(void) {
  const size_t size = nondet_u8();
  __ESBMC_assume(size <= 8);
  uint8_t* const bytes = malloc(size);  // so that a ninth byte is beyond its end, and a fifth of four
  const int whole = size == 8;

  struct canard_bus_bench_request_t request;
  CLAIM((canard_bus_bench_request_unpack(&request, bytes, size) == 0) == whole);
  struct canard_bus_bench_session_t session;
  CLAIM((canard_bus_bench_session_unpack(&session, bytes, size) == 0) == whole);
  struct canard_bus_arm_request_t arm;
  CLAIM((canard_bus_arm_request_unpack(&arm, bytes, size) == 0) == whole);
  struct canard_bus_plan_begin_t begin;
  CLAIM((canard_bus_plan_begin_unpack(&begin, bytes, size) == 0) == whole);
  struct canard_bus_plan_data_t data;
  CLAIM((canard_bus_plan_data_unpack(&data, bytes, size) == 0) == whole);
  struct canard_bus_log_request_t log;
  CLAIM((canard_bus_log_request_unpack(&log, bytes, size) == 0) == whole);

  if (whole) {
    claim_angle(request.canard_1);
    claim_angle(request.canard_2);
    claim_angle(request.canard_3);
    claim_angle(request.canard_4);
    uint8_t again[8];
    CLAIM(canard_bus_bench_request_pack(again, &request, sizeof again) == 8);
    for (int i = 0; i < 8; ++i) {
      CLAIM(again[i] == bytes[i]);  // a request has no unused bits
    }
    REACHABLE(1, canard_bus_bench_request_canard_1_decode(request.canard_1) < -20.0F);
  }
  REACHABLE(2, size == 7);
  return 0;
}
