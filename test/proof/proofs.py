# SPDX-License-Identifier: MIT
"""What ./dev prove proves: a row for each property. Each names errors that would break it; the same run must refute them."""

import proofs_avionics
import proofs_core

PROOFS = [*proofs_core.PROOFS, *proofs_avionics.PROOFS]
