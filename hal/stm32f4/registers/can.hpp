// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

/// One frame, to be sent or received. RM0090 section 32.9.3.
struct CanMailbox {
  Register identifier;  ///< TIxR, RIxR
  Register length;      ///< TDTxR, RDTxR
  Register data_low;    ///< TDLxR, RDLxR: byte 0 in the lowest bits
  Register data_high;   ///< TDHxR, RDHxR
};

/// bxCAN. RM0090 section 32.9.
struct Can {
  Register mcr;
  Register msr;
  Register tsr;
  Register rf0r;
  Register rf1r;
  Register ier;
  Register esr;
  Register btr;
  Register reserved_020[88];
  CanMailbox transmit[3];
  CanMailbox receive[2];
  Register reserved_1d0[12];
  Register fmr;
  Register fm1r;
  Register reserved_208;
  Register fs1r;
  Register reserved_210;
  Register ffa1r;
  Register reserved_218;
  Register fa1r;
  Register reserved_220[8];
  Register filter[28][2];
};
static_assert(offsetof(Can, btr) == 0x1C);
static_assert(offsetof(Can, transmit) == 0x180);
static_assert(offsetof(Can, receive) == 0x1B0);
static_assert(offsetof(Can, fmr) == 0x200);
static_assert(offsetof(Can, fs1r) == 0x20C);
static_assert(offsetof(Can, ffa1r) == 0x214);
static_assert(offsetof(Can, fa1r) == 0x21C);
static_assert(offsetof(Can, filter) == 0x240);
static_assert(sizeof(Can) == 0x320);

// Section 32.9.2.
inline constexpr std::uint32_t can_mcr_inrq = 1U << 0U;
inline constexpr std::uint32_t can_mcr_sleep = 1U << 1U;
inline constexpr std::uint32_t can_mcr_txfp = 1U << 2U;  ///< mailboxes in the order of their requests
inline constexpr std::uint32_t can_mcr_rflm = 1U << 3U;  ///< a full FIFO keeps what it has
inline constexpr std::uint32_t can_mcr_nart = 1U << 4U;  ///< no automatic retransmission
inline constexpr std::uint32_t can_mcr_abom = 1U << 6U;  ///< bus-off ends by itself
inline constexpr std::uint32_t can_mcr_dbf = 1U << 16U;  ///< stands still while a debugger holds the processor
inline constexpr std::uint32_t can_msr_inak = 1U << 0U;
inline constexpr std::uint32_t can_msr_erri = 1U << 2U;  ///< cleared by writing 1
// Of mailbox 0; the other two lie 8 and 16 bits higher.
inline constexpr std::uint32_t can_tsr_rqcp = 1U << 0U;  ///< cleared by writing 1, and TXOK with it
inline constexpr std::uint32_t can_tsr_txok = 1U << 1U;
inline constexpr std::uint32_t can_tsr_abrq = 1U << 7U;
inline constexpr std::uint32_t can_tsr_bits_per_mailbox = 8;
inline constexpr std::uint32_t can_tsr_tme = 1U << 26U;  ///< mailbox 0 is empty; the other two one bit higher each
inline constexpr std::uint32_t can_rfr_fmp = 3U << 0U;   ///< frames in the FIFO
inline constexpr std::uint32_t can_rfr_fovr = 1U << 4U;  ///< cleared by writing 1
inline constexpr std::uint32_t can_rfr_rfom = 1U << 5U;  ///< releases the oldest; cleared by the controller when it has
inline constexpr std::uint32_t can_ier_tmeie = 1U << 0U;
inline constexpr std::uint32_t can_ier_fmpie0 = 1U << 1U;
inline constexpr std::uint32_t can_ier_bofie = 1U << 10U;
inline constexpr std::uint32_t can_ier_lecie = 1U << 11U;
inline constexpr std::uint32_t can_ier_errie = 1U << 15U;
inline constexpr std::uint32_t can_esr_ewgf = 1U << 0U;
inline constexpr std::uint32_t can_esr_epvf = 1U << 1U;
inline constexpr std::uint32_t can_esr_boff = 1U << 2U;
inline constexpr std::uint32_t can_esr_lec = 7U << 4U;  ///< 0: none; 7: none since software wrote 7
inline constexpr std::uint32_t can_btr_ts1_place = 16;
inline constexpr std::uint32_t can_btr_ts2_place = 20;
inline constexpr std::uint32_t can_btr_sjw_place = 24;

// Section 32.9.3.
inline constexpr std::uint32_t can_identifier_txrq = 1U << 0U;
inline constexpr std::uint32_t can_identifier_rtr = 1U << 1U;
inline constexpr std::uint32_t can_identifier_ide = 1U << 2U;
inline constexpr std::uint32_t can_extended_place = 3;
inline constexpr std::uint32_t can_standard_place = 21;
inline constexpr std::uint32_t can_length_dlc = 15U << 0U;

// Section 32.9.4.
inline constexpr std::uint32_t can_fmr_finit = 1U << 0U;
/// Of a 16-bit filter: RTR, IDE and three extended bits lie below the 11 bits.
inline constexpr std::uint32_t can_filter_standard_place = 5;

}  // namespace fantail::hal::stm32f4::registers
