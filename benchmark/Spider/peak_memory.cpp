// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peak_memory.h"

#include <fstream>
#include <stdexcept>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace CGAL {
namespace Spider {
namespace benchmark {

namespace {

std::size_t resident_bytes()
{
  std::size_t total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident; // in pages
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t peak_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

// the child's life: it must not return into its parent's code
[[noreturn]] void work_and_tell(const std::function<void()>& work, int pipe_end)
{
  const std::size_t before = resident_bytes();
  work();
  const std::size_t peak = peak_bytes(), growth = peak > before ? peak - before : 0;
  const bool told = write(pipe_end, &growth, sizeof(growth)) == sizeof(growth);
  _exit(told ? 0 : 1);
}

} // namespace

std::size_t peak_memory(const std::function<void()>& work)
{
  malloc_trim(0); // else the work could use free memory that is counted already
  int ends[2];
  if(pipe(ends) != 0)
    throw std::runtime_error("cannot make a pipe to measure memory");
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("cannot start a process to measure memory");
  if(child == 0)
    work_and_tell(work, ends[1]);

  close(ends[1]);
  std::size_t growth = 0;
  const bool heard = read(ends[0], &growth, sizeof(growth)) == sizeof(growth);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if(!heard)
    throw std::runtime_error("the process that measures memory has died");
  return growth;
}

} // namespace benchmark
} // namespace Spider
} // namespace CGAL
