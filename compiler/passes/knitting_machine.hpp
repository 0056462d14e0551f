/// A virtual V-bed machine: runs needle instructions and keeps what they make.
#pragma once

#include <optional>
#include <vector>

#include "compiler/passes/machine_rules.hpp"
#include "compiler/passes/needle_beds.hpp"
#include "compiler/stitch_graph.hpp"

namespace wale {

/// What a machine cannot do is for the caller to keep away by the rules and crowd(); nothing here depends on it save
/// that needles lie on the beds, and that no needle is transferred to itself.
class KnittingMachine {
 public:
  explicit KnittingMachine(const Program&);

  const MachineState& state() const { return state_; }

  /// Nothing, or why an instruction would bring too many loops together, here or in all.
  std::optional<Fault> crowd(const Instruction&);

  void run(const Instruction&, int index);

  /// What has been knitted, with what is left on the needles. The machine is empty then.
  StitchGraph finish();

 private:
  /// A carrier between coming in and going out.
  struct YarnEnd {
    int yarn = -1;  // index into StitchGraph::yarns, once it has made a loop
    int came_in = -1;
    int course = 0;
    Direction direction = Direction::none;
    double position = 0;
    Bed bed = Bed::front;
    Stop stop;
    std::vector<Miss> misses;  // before its first loop
  };

  YarnEnd& end_of(int carrier) { return ends_[static_cast<std::size_t>(carrier)]; }
  Loop& loop_at(int loop) { return graph_.loops[static_cast<std::size_t>(loop)]; }
  int in_use(const Instruction&);

  void bring_in(const Instruction&);
  void take_out(YarnEnd&, int instruction);
  void pass(const Instruction&, YarnEnd&) const;
  void miss(const Instruction&, YarnEnd&);
  void stitch(const Instruction&);
  std::vector<int> by_depth(std::vector<int> carriers) const;
  void move(const LoopStack&, const Needle& to);
  void release(const LoopStack&, bool knitted);
  void drag(const Instruction&);
  void make_loop(const Instruction&, int carrier, std::vector<int> through);
  void begin_yarn(int carrier, YarnEnd&);

  Plating plating_;
  MachineState state_;
  NeedleBeds beds_;
  std::vector<YarnEnd> ends_;         // by carrier
  std::vector<bool> pulled_through_;  // by loop: whether something was pulled through it
  StitchGraph graph_;
  std::size_t ties_ = 0;
  int needles_in_use_ = 0;
  int now_ = 0;  // the instruction at hand
};

}  // namespace wale
