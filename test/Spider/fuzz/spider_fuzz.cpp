// Copyright (c) 2026 The Spider developers.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls every function on meshes and with parameters made at random, and checks what they promise. A case depends on
// the seed and its number alone: `spider_fuzz --seed S --first N --cases 1` repeats it.

#include "fuzz_calls.h"
#include "fuzz_checks.h"

#include <CLI/CLI.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace {

/// runs one case.
void run(std::uint64_t seed, std::uint64_t number)
{
  fuzz::Random random(seed, number);
  fuzz::Mesh mesh = fuzz::random_mesh(random);
  if(mesh.is_empty())
    return;
  const fuzz::Settings settings = fuzz::random_settings(mesh, random);
  bool refused = false;
  try
  {
    fuzz::call_at_points(mesh, settings, random);
  }
  catch(const std::invalid_argument& refusal)
  {
    refused = true;
    fuzz::expect(!settings.are_valid, std::string("what is right isn't refused: ") + refusal.what());
  }
  fuzz::expect(settings.are_valid || refused, "what is wrong is refused");
  if(settings.are_valid)
    fuzz::call_on_whole_mesh(mesh, settings, random);
}

/// ends the program when a case takes more of the processor's time than any should: it may well have to wait for that.
class Watchdog
{
public:
  explicit Watchdog(const std::atomic<std::uint64_t>& current) : thread_([this, &current] { watch(current); }) {}
  ~Watchdog()
  {
    is_over_ = true;
    thread_.join();
  }

private:
  void watch(const std::atomic<std::uint64_t>& current) const
  {
    constexpr std::clock_t longest = 30 * CLOCKS_PER_SEC; // a thousand times what cases take under sanitizers
    std::uint64_t last = current;
    for(std::clock_t began = std::clock(); !is_over_ && std::clock() - began < longest;)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if(current != last)
      {
        last = current;
        began = std::clock();
      }
    }
    if(is_over_)
      return;
    std::cerr << "case " << last << " hangs" << std::endl;
    std::_Exit(EXIT_FAILURE);
  }

  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

} // namespace

int main(int argc, char* argv[])
{
  std::uint64_t cases = 1000, seed = 1, first = 0;
  CLI::App app("Calls every function of Spider on random meshes with random parameters, and checks what they promise.");
  app.add_option("--cases", cases, "how many")->capture_default_str();
  app.add_option("--seed", seed, "a case depends on this and on its number alone")->capture_default_str();
  app.add_option("--first", first, "the number of the first case")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  constexpr std::uint64_t cases_per_report = 50000;
  std::uint64_t failures = 0;
  std::atomic<std::uint64_t> current{first};
  const Watchdog watchdog(current);
  for(; current < first + cases; ++current)
  {
    try
    {
      run(seed, current);
    }
    catch(const std::exception& failure)
    {
      ++failures;
      std::cout << "case " << current << " of seed " << seed << ": " << failure.what() << std::endl;
    }
    if((current - first + 1) % cases_per_report == 0)
      std::cout << current - first + 1 << " cases, " << failures << " failures" << std::endl;
  }
  std::cout << cases << " cases, " << failures << " failures" << std::endl;
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
