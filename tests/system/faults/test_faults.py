"""Each fault once, at a step that chance chooses; its seed is printed.

    usage: test_faults.py TREMOLO CLOCK processes|ranks suite|acceptance [SEED [NAME ...]]

CLOCK is the library of jumping_clock.c. `ranks` are those of a domain on several of them. `suite` is one fault of each
kind, `acceptance` all others. The whole table, many kills and the soak are in ./fault_campaign.
"""

import random
import sys
import threading
import time
import traceback
from concurrent.futures import ThreadPoolExecutor

import machine_faults, process_faults, rank_faults, rogue_faults  # they register themselves
from faults import FAULTS, Faults

tremolo, clock, of, rows, *rest = sys.argv[1:]
of_ranks = of == "ranks"
seed = int(rest[0]) if rest else random.SystemRandom().randrange(1 << 32)
names = rest[1:]
print(f"seed {seed}", flush=True)
faults = Faults(tremolo, clock, seed)
rank_faults.timed(faults) if of_ranks else (faults.slope(), faults.box())
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


wanted = [fault for fault in FAULTS if rank_faults.is_of_ranks(fault) == of_ranks
          and (fault.name in names if names else fault.in_suite == (rows == "suite"))]
# Processes wait most of the time; ranks do not, and would slow each other beyond what is promised.
with ThreadPoolExecutor(1 if of_ranks else 4) as pool:
    list(pool.map(check, wanted))
print(f"{len(wanted)} faults, {len(failed)} failed", *failed)
sys.exit(bool(failed))
