// SPDX-License-Identifier: MIT
// Loaded with LD_PRELOAD into every process of the tests: writes which system files it reads into the file named by
// FANTAIL_READ_LOG, which must exist. A line is the program, its first words and what it reads, with tabs between.
// declared_packages.py reads it. What was loaded by the dynamic linker is logged at the start and at the exit.
//
// Not seen: a program that is linked statically or started with an emptied environment, what glibc opens for itself
// (locales, time zones), what is loaded later by a process that a signal ends, and paths that are relative.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <link.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/statfs.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

enum { hostfs = 0x00c0ffee, words_shown = 100 };

static char log_name[512];  // empty: nothing is logged
static char reader[PATH_MAX + words_shown];
static size_t reader_length;

// Hashes of what this process has logged. When it is full a line may come twice.
static uint64_t seen[4096];

static int is_new(const char* path) {
  uint64_t hash = 14695981039346656037U;
  for (const char* c = path; *c != '\0'; ++c) {
    hash = (hash ^ (unsigned char)*c) * 1099511628211U;
  }
  hash |= 1;
  for (uint64_t i = 0; i < 64; ++i) {
    uint64_t there = 0;
    if (__atomic_compare_exchange_n(&seen[((hash >> 8) + i) % 4096], &there, hash, 0, __ATOMIC_RELAXED,
                                    __ATOMIC_RELAXED)) {
      return 1;
    }
    if (there == hash) {
      return 0;
    }
  }
  return 1;
}

static int is_system(const char* path) {
  static const char* const folders[] = {"/usr/", "/lib", "/bin/", "/sbin/", "/etc/", "/opt/"};
  for (size_t i = 0; i < sizeof folders / sizeof folders[0]; ++i) {
    if (strncmp(path, folders[i], strlen(folders[i])) == 0) {
      return 1;
    }
  }
  return 0;
}

// Plain system calls, no buffer: this may run on a small stack (linux.uml), in a forked child, on any thread. Opened
// anew for each line, because a test may close or count what is open.
static void write_line(const char* by, size_t by_length, const char* path) {
  struct rlimit limit;
  // A test that forbids long files would be killed for the length of this one.
  if (getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) {
    return;
  }
  const long log = syscall(SYS_openat, AT_FDCWD, log_name, O_WRONLY | O_APPEND | O_CLOEXEC);
  if (log < 0) {
    return;
  }
  const struct iovec parts[] = {{(void*)by, by_length}, {(void*)path, strlen(path)}, {"\n", 1}};
  syscall(SYS_writev, log, parts, 3);
  syscall(SYS_close, log);
}

static void note(const char* path) {
  const int error = errno;
  while (path[0] == '/' && path[1] == '/') {  // as linux.uml says it
    ++path;
  }
  if (log_name[0] != '\0' && is_system(path) && is_new(path)) {
    write_line(reader, reader_length, path);
  }
  errno = error;
}

// "/usr/bin/dash<tab>sh x.sh --quick <tab>" for a process in /proc.
static size_t describe(const char* process, char* out, char* program) {
  char name[64];
  snprintf(name, sizeof name, "/proc/%s/exe", process);
  ssize_t length = readlink(name, program, PATH_MAX - 1);
  program[length > 0 ? length : 0] = '\0';
  size_t used = (size_t)sprintf(out, "%s\t", program);
  snprintf(name, sizeof name, "/proc/%s/cmdline", process);
  const long file = syscall(SYS_openat, AT_FDCWD, name, O_RDONLY | O_CLOEXEC);
  length = file < 0 ? 0 : read((int)file, out + used, words_shown - 8);
  if (file >= 0) {
    syscall(SYS_close, file);
  }
  for (ssize_t i = 0; i < length; ++i, ++used) {
    if ((unsigned char)out[used] <= ' ') {
      out[used] = ' ';
    }
  }
  out[used++] = '\t';
  return used;
}

static int note_loaded(struct dl_phdr_info* object, size_t size, void* data) {
  (void)size;
  (void)data;
  note(object->dlpi_name);
  return 0;
}

// Of every function that opens there is one in the end; the names differ only where a long file does not fit a long.
static int (*next_openat64)(int, const char*, int, ...);
static FILE* (*next_fopen64)(const char*, const char*);

// Called by whoever comes first: another library's constructor may open files before this one's has run.
static void find_next(void) {
  *(void**)&next_openat64 = dlsym(RTLD_NEXT, "openat64");
  *(void**)&next_fopen64 = dlsym(RTLD_NEXT, "fopen64");
}

__attribute__((constructor)) static void begin(void) {
  const int error = errno;
  find_next();
  const char* name = getenv("FANTAIL_READ_LOG");
  struct statfs system;
  // Not from inside of a user-mode Linux guest: there the end of the file is not known, and lines of others would be
  // written over. What the guest reads is logged outside, by linux.uml.
  if (name != NULL && strlen(name) < sizeof log_name && statfs(name, &system) == 0 && system.f_type != hostfs) {
    static char program[PATH_MAX];
    static char parent[sizeof reader];
    char number[16];
    snprintf(number, sizeof number, "%d", (int)getppid());
    const size_t parent_length = describe(number, parent, program);
    reader_length = describe("self", reader, program);
    strcpy(log_name, name);
    if (is_system(program) && is_new(program)) {
      write_line(parent, parent_length, program);  // a program is read by who starts it
    }
    dl_iterate_phdr(note_loaded, NULL);
  }
  errno = error;
}

__attribute__((destructor)) static void end(void) { dl_iterate_phdr(note_loaded, NULL); }

static int open_and_note(int folder, const char* path, int flags, mode_t mode) {
  if (next_openat64 == NULL) {
    find_next();
  }
  const int file = next_openat64(folder, path, flags, mode);
  if (file >= 0) {
    note(path);
  }
  return file;
}

// The names with _2 are what a fortified program calls.
#define OPENS(name, name_2, FOLDER_AND, folder)                       \
  int name(FOLDER_AND const char* path, int flags, ...) {             \
    mode_t mode = 0;                                                  \
    if ((flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE) { \
      va_list rest;                                                   \
      va_start(rest, flags);                                          \
      mode = va_arg(rest, mode_t);                                    \
      va_end(rest);                                                   \
    }                                                                 \
    return open_and_note(folder, path, flags, mode);                  \
  }                                                                   \
  int name_2(FOLDER_AND const char* path, int flags);                 \
  int name_2(FOLDER_AND const char* path, int flags) { return open_and_note(folder, path, flags, 0); }

#define NO_FOLDER
#define A_FOLDER int folder,
OPENS(open, __open_2, NO_FOLDER, AT_FDCWD)
OPENS(open64, __open64_2, NO_FOLDER, AT_FDCWD)
OPENS(openat, __openat_2, A_FOLDER, folder)
OPENS(openat64, __openat64_2, A_FOLDER, folder)

FILE* fopen64(const char* path, const char* mode) {
  if (next_fopen64 == NULL) {
    find_next();
  }
  FILE* const file = next_fopen64(path, mode);
  if (file != NULL) {
    note(path);
  }
  return file;
}
FILE* fopen(const char* path, const char* mode) { return fopen64(path, mode); }
