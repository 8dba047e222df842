/* Preloaded into a process, lets its wall clock jump an hour forth and back every tenth of a second. Monotonic
   clocks are left alone. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <sys/time.h>
#include <time.h>

typedef int (*real_clock)(clockid_t, struct timespec*);

static int real(clockid_t id, struct timespec* t) {
  static real_clock next;
  if (!next)
    next = (real_clock)dlsym(RTLD_NEXT, "clock_gettime");
  return next(id, t);
}

static long jump(void) {
  struct timespec t;
  real(CLOCK_MONOTONIC, &t);
  return t.tv_nsec / 100000000 % 2 ? 3600 : -3600;
}

int clock_gettime(clockid_t id, struct timespec* t) {
  const int status = real(id, t);
  if (id == CLOCK_REALTIME || id == CLOCK_REALTIME_COARSE)
    t->tv_sec += jump();
  return status;
}

int gettimeofday(struct timeval* tv, void* zone) {
  struct timespec t;
  (void)zone;
  clock_gettime(CLOCK_REALTIME, &t);
  tv->tv_sec = t.tv_sec;
  tv->tv_usec = t.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* out) {
  struct timespec t;
  clock_gettime(CLOCK_REALTIME, &t);
  if (out)
    *out = t.tv_sec;
  return t.tv_sec;
}
