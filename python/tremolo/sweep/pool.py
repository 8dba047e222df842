"""The runs of a sweep on this machine, some at a time."""

import os
from concurrent import futures

from tremolo.sweep.plan import Order
from tremolo.sweep.task import Task


def carry_out(plan, pending, tremolo, jobs=None, ranks=1):
    """Yields the number of each run as it ends; Ctrl-C, or leaving the loop, ends those that go on.

    jobs: runs at a time; each has its share of the cores. ranks: of the domain of each.
    """
    cores = len(os.sched_getaffinity(0))
    jobs = max(1, min(jobs or cores // ranks, len(pending)))
    threads = max(1, cores // (jobs * ranks))
    order = Order(plan, pending)
    tasks = {}
    with futures.ThreadPoolExecutor(max_workers=jobs) as pool:

        def start(number):
            task = Task(plan, number, tremolo, threads, records=number in order.records, ranks=ranks)
            running = pool.submit(task.carry_out)
            tasks[running] = number, task
            return running

        going = {start(number) for number in order.first}
        try:
            while going:
                ended, going = futures.wait(going, return_when=futures.FIRST_COMPLETED)
                for one in ended:
                    one.result()  # what the task itself did wrong
                    number, _ = tasks.pop(one)
                    yield number
                    going |= {start(other) for other in order.then.get(number, [])}
        finally:
            for running, (_, task) in tasks.items():
                running.cancel()
                task.stop()
