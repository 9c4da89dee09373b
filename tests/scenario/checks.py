# SPDX-License-Identifier: BSD-3-Clause
"""What a test finds wrong is said at once and counted, and the test goes on."""

_faults = 0


def check(holds, sentence):
    """Says the sentence where it does not hold; whether it does."""
    global _faults
    if not holds:
        _faults += 1
        print("FAULT:", sentence, flush=True)
    return holds


def outcome():
    """What the test exits with, once it has said how many faults there were."""
    print("faults:", _faults)
    return 1 if _faults else 0
