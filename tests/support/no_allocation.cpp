// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/no_allocation.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <ctime>

// glibc's own names for what malloc and its kin are when nobody interposes them; asking dlsym
// for them would allocate
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

thread_local bool watching = false;
thread_local support::Calls counted;

void count(long support::Calls::*kind, const char* name) {
  if (!watching) return;
  if (counted.all() == 0) counted.first = name;
  ++(counted.*kind);
}
void allocation(const char* name) { count(&support::Calls::allocations, name); }
void wait(const char* name) { count(&support::Calls::waits, name); }
void file(const char* name) { count(&support::Calls::files, name); }

/// The function that this program's hides. The condition variables have an old version too.
template <class F>
F* next(const char* name, const char* version = nullptr) {
  void* found = version != nullptr ? dlvsym(RTLD_NEXT, name, version) : dlsym(RTLD_NEXT, name);
  if (found == nullptr) found = dlsym(RTLD_NEXT, name);
  return reinterpret_cast<F*>(found);
}

}  // namespace

namespace support {

NoAllocation::NoAllocation() {
  counted = {};
  watching = true;
}
NoAllocation::~NoAllocation() { watching = false; }
Calls NoAllocation::calls() const { return counted; }

}  // namespace support

extern "C" {

void* malloc(std::size_t size) {
  allocation("malloc");
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  allocation("calloc");
  return __libc_calloc(n, size);
}
void* realloc(void* p, std::size_t size) {
  allocation("realloc");
  return __libc_realloc(p, size);
}
void free(void* p) {
  if (p != nullptr) allocation("free");
  __libc_free(p);
}
void* memalign(std::size_t alignment, std::size_t size) {
  allocation("memalign");
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  allocation("aligned_alloc");
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** p, std::size_t alignment, std::size_t size) {
  allocation("posix_memalign");
  *p = __libc_memalign(alignment, size);
  return *p == nullptr ? ENOMEM : 0;
}

int pthread_mutex_lock(pthread_mutex_t* mutex) {
  wait("pthread_mutex_lock");
  static auto* const real = next<int(pthread_mutex_t*)>("pthread_mutex_lock");
  return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
  wait("pthread_mutex_trylock");
  static auto* const real = next<int(pthread_mutex_t*)>("pthread_mutex_trylock");
  return real(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) {
  wait("pthread_rwlock_rdlock");
  static auto* const real = next<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  return real(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) {
  wait("pthread_rwlock_wrlock");
  static auto* const real = next<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  return real(lock);
}
int pthread_cond_wait(pthread_cond_t* cond, pthread_mutex_t* mutex) {
  wait("pthread_cond_wait");
  static auto* const real =
      next<int(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait", "GLIBC_2.3.2");
  return real(cond, mutex);
}
int pthread_cond_timedwait(pthread_cond_t* cond, pthread_mutex_t* mutex, const timespec* until) {
  wait("pthread_cond_timedwait");
  static auto* const real = next<int(pthread_cond_t*, pthread_mutex_t*, const timespec*)>(
      "pthread_cond_timedwait", "GLIBC_2.3.2");
  return real(cond, mutex, until);
}
int pthread_cond_signal(pthread_cond_t* cond) {
  wait("pthread_cond_signal");
  static auto* const real = next<int(pthread_cond_t*)>("pthread_cond_signal", "GLIBC_2.3.2");
  return real(cond);
}
int sem_wait(sem_t* semaphore) {
  wait("sem_wait");
  static auto* const real = next<int(sem_t*)>("sem_wait");
  return real(semaphore);
}
int nanosleep(const timespec* time, timespec* rest) {
  wait("nanosleep");
  static auto* const real = next<int(const timespec*, timespec*)>("nanosleep");
  return real(time, rest);
}
int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* rest) {
  wait("clock_nanosleep");
  static auto* const real =
      next<int(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
  return real(clock, flags, time, rest);
}
int usleep(useconds_t time) {
  wait("usleep");
  static auto* const real = next<int(useconds_t)>("usleep");
  return real(time);
}
int sched_yield() noexcept {
  wait("sched_yield");
  static auto* const real = next<int()>("sched_yield");
  return real();
}
int poll(pollfd* fds, nfds_t n, int timeout) {
  wait("poll");
  static auto* const real = next<int(pollfd*, nfds_t, int)>("poll");
  return real(fds, n, timeout);
}

int open(const char* path, int flags, ...) {
  file("open");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  static auto* const real = next<int(const char*, int, ...)>("open");
  return real(path, flags, mode);
}
ssize_t read(int fd, void* buffer, std::size_t size) {
  file("read");
  static auto* const real = next<ssize_t(int, void*, std::size_t)>("read");
  return real(fd, buffer, size);
}
ssize_t write(int fd, const void* buffer, std::size_t size) {
  file("write");
  static auto* const real = next<ssize_t(int, const void*, std::size_t)>("write");
  return real(fd, buffer, size);
}

}  // extern "C"
