/// What each effect costs, alone and with others: time of a force evaluation, and memory of the world that has it. Sums
/// and wholes are compared in docs/effects.md.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <array>

#include "bench/jersey_swatch.hpp"

namespace wale {
namespace {

constexpr int wales = 20, courses = 20;
constexpr double shrinkage = 0.8;  // of the yarn as laid: about what tightening takes off

const JerseySwatch& swatch() {
  static const JerseySwatch jersey(wales, courses, shrinkage, JerseySwatch::Mounting::free);
  return jersey;
}

/// Moving, so that what damps has work to do.
State moving() {
  State state = swatch().state();
  state.v = 0.01 * state.q;
  return state;
}

struct Subset {
  const char* name;
  std::vector<EffectSpec> effects;
};

Tether some_tether() {
  Tether tether;
  for (int segment = 0; segment < swatch().fabric().segment_count() / courses; ++segment)
    tether.segments.push_back(segment);
  return tether;
}

std::vector<Subset> subsets() {
  const Stretch stretch;
  const Bend bend;
  const Contact contact;
  const ContactDamping damping{20, 10};
  const Friction friction;
  const Gravity gravity;
  const Drag drag;
  const Plates plates;
  const Twist twist{.to = 1e-6};
  const Tether tether = some_tether();
  return {{"nothing", {}},
          {"stretch", {stretch}},
          {"bend", {bend}},
          {"gravity", {gravity}},
          {"drag", {drag}},
          {"plates", {plates}},
          {"tether", {tether}},
          {"contact", {contact}},
          {"contact_damping", {damping}},
          {"friction", {friction}},
          {"twist", {twist}},
          {"stretch+bend", {stretch, bend}},
          {"stretch+bend+contact", {stretch, bend, contact}},
          {"stretch+bend+contact+friction", {stretch, bend, contact, friction}},
          {"contact+contact_damping+friction", {contact, damping, friction}},
          {"all_but_twist", {stretch, bend, gravity, drag, plates, tether, contact, damping, friction}},
          {"all", {stretch, bend, gravity, drag, plates, tether, contact, damping, friction, twist}}};
}

void evaluate(benchmark::State& bench, const Subset& of) {
  const State state = moving();
  const std::size_t before = ::mallinfo2().uordblks;
  World world(swatch().fabric(), of.effects, 0.0, state);
  double energy = 0;
  Points force = Points::Zero(3, state.q.cols());
  Load load{.energy = &energy, .force = &force};
  world.prepare(state);
  world.evaluate(state, load);
  bench.counters["kB"] = static_cast<double>(::mallinfo2().uordblks - before) / 1e3;
  for (auto _ : bench) {
    world.evaluate(state, load);
    benchmark::DoNotOptimize(energy);
  }
  bench.counters["s_a_segment"] = benchmark::Counter(
      swatch().fabric().segment_count(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// They are made once, before main: Google Benchmark reads its list then.
const bool registered = [] {
  for (const Subset& subset : subsets())
    benchmark::RegisterBenchmark((std::string("effects/") + subset.name).c_str(), [subset](benchmark::State& bench) {
      evaluate(bench, subset);
    })->Unit(benchmark::kMicrosecond);
  return true;
}();

}  // namespace
}  // namespace wale
