"""Each fault once, at a step that chance chooses; its seed is printed.

    usage: test_faults.py TREMOLO CLOCK [SEED [NAME ...]]

CLOCK is the library of jumping_clock.c. The whole table, many kills and the soak are in ./fault_campaign.
"""

import random
import sys
import threading
import time
import traceback
from concurrent.futures import ThreadPoolExecutor

import machine_faults, process_faults, rank_faults, rogue_faults  # they register themselves
from faults import FAULTS, Faults

tremolo, clock, *rest = sys.argv[1:]
seed = int(rest[0]) if rest else random.SystemRandom().randrange(1 << 32)
names = rest[1:]
print(f"seed {seed}", flush=True)
faults = Faults(tremolo, clock, seed)
faults.slope(), faults.box(), rank_faults.timed(faults)
failed = []
printing = threading.Lock()


def check(fault):
    before = time.monotonic()
    try:
        words = fault.check(faults)
    except Exception:
        failed.append(fault.name)
        words = "FAILED\n" + traceback.format_exc()
    with printing:
        print(f"{time.monotonic() - before:6.2f} s  {fault.name}: {words}", flush=True)


wanted = [fault for fault in FAULTS if not names or fault.name in names]
# Most of them wait most of the time; ranks do not, and would slow the others beyond what is promised.
for faults_at_once, of_ranks in ((4, False), (1, True)):
    with ThreadPoolExecutor(faults_at_once) as pool:
        list(pool.map(check, [fault for fault in wanted if rank_faults.is_of_ranks(fault) == of_ranks]))
print(f"{len(FAULTS)} faults, {len(failed)} failed", *failed)
sys.exit(bool(failed))
