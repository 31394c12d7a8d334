/// The builder behind build.h: one class, one source file per concept.
#ifndef HLSC_DESIGN_PROCESS_BUILDER_H
#define HLSC_DESIGN_PROCESS_BUILDER_H

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/TargetLibraryInfo.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "design/build.h"
#include "design/names.h"
#include "middle/array_access.h"
#include "middle/llvm_headers.h"

namespace hlsc {

/// An array dimension split over banks.
struct Partition {
  enum Kind { kNone, kComplete, kCyclic, kBlock } kind = kNone;
  uint64_t factor = 1;
};

/// Something in memory: local array, static, or what a pointer parameter points to.
struct MemoryObject {
  std::string name;
  llvm::Type* type = nullptr;  ///< Of allocas and globals.
  std::vector<MemoryLeaf> leaves;
  std::vector<unsigned> widths;  ///< Of each leaf.
  std::vector<bool> signedness;
  std::vector<std::string> leaf_names;
  int argument = -1;
  int llvm_argument = -1;
  bool is_aggregate =
      false;  ///< AGGREGATE on an array of structs outside that is only read: one word an element.
  bool is_scalar_port = false;                          ///< Leaves are scalar ports, not memories.
  std::vector<std::vector<Partition>> partitions;       ///< By leaf and dimension.
  std::map<uint64_t, std::string> aggregates;           ///< Bank -> name of its memory of whole elements.
  std::map<std::pair<size_t, uint64_t>, int> memories;  ///< (leaf, bank) -> index in Process::memories.
  std::map<size_t, int> inputs, outputs;                ///< leaf -> index in Process::scalars.
};

/// Where a load or store goes.
struct Address {
  MemoryObject* object = nullptr;
  size_t leaf = 0;
  std::vector<ValueId> subscripts;   ///< One per dimension of the leaf, or a single linear one.
  std::vector<llvm::Value*> values;  ///< What the subscripts are in LLVM's form; none of a linear one.
  bool is_linear = false;
};

/// Builds one function's process, or the region of the top.
class ProcessBuilder {
 public:
  ProcessBuilder(const Program& program, const MiddleResult& middle, const std::string& function,
                 const std::string& module_name);
  Process build();
  Region build_region(const std::vector<Process>& processes);

 private:
  /// Address and bank of a subscript list; the bank is a value of its own when it is not constant.
  struct Place {
    ValueId bank;
    ValueId address;
    uint64_t banks = 1;
  };

  /// A stream that an access goes to when `condition` holds; kNoValue: always. A subscript that is known only
  /// at run time leads to one place per element.
  struct StreamPlace {
    int stream;
    ValueId condition;
  };

  // Blocks and control flow (build.cpp)
  [[noreturn]] void refuse(const llvm::Instruction& instruction, const std::string& sentence);
  void build_block(llvm::BasicBlock& block);
  ValueId returned_value(llvm::ReturnInst& ret);
  void set_result(ValueId value, const llvm::Instruction& source);
  /// In a loop of calls: takes the arguments.
  void begin_call();
  static std::string block_name(const llvm::BasicBlock& block);
  void copy_inout_ports();
  void read_loop(llvm::BasicBlock& block);
  void collect_loops();
  SourceLoop described(const llvm::Loop& loop);
  void finish_block(llvm::BasicBlock& block);
  Terminator terminator_of(llvm::Instruction& instruction);

  // Parameters: streams, scalar ports, arrays outside (build_parameters.cpp)
  void read_parameters();
  void read_parameter(llvm::Argument& argument, const Parameter& parameter, int index);
  void add_scalar_input(llvm::Argument& argument, const Parameter& parameter, int index);
  ValueId add_input(const ScalarPort& port, unsigned type_width);
  void add_layout(MemoryObject& object, const TypeLayout& layout, const std::vector<uint64_t>& dims);
  /// A struct outside that holds arrays: each is a port of its own, and so are the other members.
  void add_member_arrays(MemoryObject& object, const TypeLayout& layout);
  void add_result_object(llvm::Argument& argument);
  void add_parameter_object(llvm::Argument& argument, const Parameter& parameter, int index);
  bool is_aggregated(llvm::Argument& argument);
  bool is_stored_to(llvm::Argument& argument);
  /// Elements of an array outside whose type does not tell: from INTERFACE depth, or the callers' arrays.
  uint64_t port_depth(llvm::Argument& argument, const Parameter& parameter);
  uint64_t elements_behind(llvm::Value* actual, uint64_t bytes);
  /// A pointer to one object: only its first element is touched.
  bool has_only_constant_zero_accesses(llvm::Value& pointer, uint64_t bytes);
  /// Which leaves of scalar ports are read and which written; both makes a register that starts from the
  /// input.
  void find_scalar_port_uses();
  void add_scalar_leaf(MemoryObject& object, size_t leaf, bool read, bool written);
  /// Structs of up to 16 bytes return in one or two integers, which hold them as memory does.
  static unsigned returned_bits(llvm::Type* type);

  // Memories and their banks (build_memories.cpp)
  MemoryObject& object_at(llvm::Value* pointer, const llvm::Instruction& access);
  std::string object_name(llvm::Value* pointer);
  void read_partitions(llvm::Value* pointer, MemoryObject& object);
  static void partition(std::vector<Partition>& partitions, const MemoryLeaf& leaf,
                        const ObjectDirective& entry);
  static bool is_fully_partitioned(const MemoryObject& object, size_t leaf);
  static uint64_t bank_count(const Partition& partition, uint64_t size);
  int memory_of(MemoryObject& object, llvm::Value* pointer, size_t leaf, uint64_t bank);
  bool is_constant_table(const llvm::GlobalVariable& global);
  /// Whether a parameter is an array outside the top, behind which a memory with two ports can lie: it is no
  /// channel between processes, not in a bank of registers, and nobody asks for a single port.
  bool may_have_two_ports(llvm::Argument& argument) const;
  std::vector<DependenceClaim> claims_of(llvm::Value* pointer, const MemoryLeaf& leaf);
  /// Contents of one bank; a single word stands for all words alike.
  std::vector<llvm::APInt> initial_words(llvm::GlobalVariable& global, const MemoryObject& object,
                                         size_t leaf, uint64_t bank, uint64_t depth);
  /// Bank and word address of an element with known subscripts.
  static std::pair<uint64_t, uint64_t> place(const MemoryObject& object, size_t leaf,
                                             const std::vector<uint64_t>& subscripts);

  // Where a pointer leads (build_addresses.cpp)
  Address decode(llvm::Value* pointer, const llvm::Instruction& access);
  Address decode_element(llvm::CallInst& call, const llvm::Instruction& access);
  void check_width(const MemoryLeaf& leaf, const llvm::Instruction& access);
  Place place_of(const Address& address, const llvm::Instruction& access);
  ValueId combined(ValueId outer, uint64_t size, ValueId inner, const llvm::Instruction& access);
  ValueId divided(ValueId value, uint64_t divisor, const llvm::Instruction& access);
  /// The block of `words` elements that a subscript always lies in: i + 8, with i below 8, is in block 1
  /// of 8.
  std::optional<uint64_t> block_of(llvm::Value* subscript, uint64_t words);
  /// The bank of a cyclic partition, when the subscript's low bits tell it: counters by steps of the factor.
  std::optional<uint64_t> lane_of(llvm::Value* subscript, uint64_t banks);
  ValueId remainder_of(ValueId value, uint64_t divisor, const llvm::Instruction& access);

  // Loads and stores (build_accesses.cpp)
  static bool is_store(const llvm::Instruction& instruction);
  ValueId load(llvm::Instruction& instruction);
  /// Bits of an aggregate's word below a leaf.
  static unsigned low_bit(const MemoryObject& object, size_t leaf);
  /// A member of an element outside: all members of one element share one access.
  ValueId load_member(const Address& address, const Place& place, llvm::Value* pointer,
                      llvm::Instruction& instruction);
  uint64_t checked_bank(const Place& place, const MemoryObject& object, const llvm::Instruction& instruction);
  ValueId store(llvm::Instruction& instruction);
  void store_output(MemoryObject& object, size_t leaf, ValueId data, ValueId predicate,
                    llvm::Instruction& instruction);

  // Operations (build_operations.cpp)
  bool is_zero(ValueId id) const {
    return process_[id].kind == OpKind::kConstant && process_[id].constant.isZero();
  }
  bool is_constant(ValueId id) const { return process_[id].kind == OpKind::kConstant; }
  ValueId add(Operation operation, const llvm::Instruction& source, const std::string& wanted_name = "");
  /// As add, for operations without effect: one that is there already in the block is used again.
  ValueId add_shared(const Operation& operation, const llvm::Instruction& source,
                     const std::string& wanted_name = "");
  static const char* kind_name(OpKind kind);
  ValueId constant_value(const llvm::APInt& constant);
  ValueId binary(OpKind kind, ValueId first, ValueId second, const llvm::Instruction& source);
  ValueId compare(CompareKind kind, ValueId first, ValueId second, const llvm::Instruction& source);
  ValueId select(ValueId condition, ValueId yes, ValueId no, const llvm::Instruction& source,
                 const std::string& name = "");
  ValueId resized(ValueId value, unsigned width, bool is_signed, const llvm::Instruction& source);
  ValueId value_of(llvm::Value* value);

  // One instruction to one operation (build_instructions.cpp)
  void build_instruction(llvm::Instruction& instruction);
  std::string name_of(llvm::Instruction& instruction);
  ValueId translated(llvm::Instruction& instruction);
  /// Selects between 1-bit values are gates.
  ValueId translated_select(llvm::Instruction& instruction, Operation operation);
  static CompareKind compare_kind(llvm::CmpInst::Predicate predicate);
  ValueId predicate_of(llvm::Value* predicate);
  ValueId translated_call(llvm::CallInst& call);
  /// Why a call that is neither inlined nor a primitive has no hardware form.
  static std::string reason_against(const llvm::CallInst& call);
  void refine(ValueId id, llvm::Instruction& instruction);

  // Stream accesses (build_streams.cpp)
  ValueId read_stream(llvm::CallInst& call);
  void write_stream(llvm::CallInst& call);
  ValueId stream_status(llvm::CallInst& call);
  /// The access' own predicate and the place's condition.
  ValueId predicate_at(llvm::Value* predicate, const StreamPlace& place, llvm::CallInst& call);
  /// All streams that an access may go to; notes the direction of each.
  std::vector<StreamPlace> stream_places(llvm::CallInst& call, bool is_input, unsigned width);
  void find_streams(llvm::Value* pointer, ValueId condition, llvm::CallInst& call,
                    std::vector<StreamPlace>& places);
  /// A global stream between two processes is a port of both.
  void add_global_stream(llvm::Value* base, uint64_t offset);
  /// Whether the scaled subscripts add up to `rest` bytes; kNoValue when they never do.
  ValueId subscripts_lead_to(const llvm::MapVector<llvm::Value*, llvm::APInt>& terms, const llvm::APInt& rest,
                             llvm::CallInst& call);

  // LLVM intrinsics as operations (build_intrinsics.cpp)
  ValueId translated_intrinsic(llvm::IntrinsicInst& call);
  ValueId saturated(llvm::IntrinsicInst& call, ValueId first, ValueId second);
  ValueId funnel_shift(llvm::IntrinsicInst& call);
  ValueId bit_of(ValueId value, unsigned bit, const llvm::Instruction& source);
  ValueId population(llvm::IntrinsicInst& call, ValueId value);
  ValueId leading_zeros(llvm::IntrinsicInst& call, ValueId value, bool from_top);
  ValueId permuted(llvm::IntrinsicInst& call, ValueId value, unsigned group);

  // Dataflow regions (build_region.cpp)
  int process_called(const llvm::CallInst& call) const;
  /// Refuses a local stream without writer or reader.
  void check_ends(const RegionStream& stream) const;
  void build_instance(llvm::CallInst& call, int index);
  /// Refuses calls in several loops, or in a loop and outside.
  void note_loop(llvm::CallInst& call);
  /// At the end of a loop's iteration: the head starts a run.
  void write_run(llvm::Instruction& source);
  /// Whether the process takes one struct of which `memory` is an array, not an array of structs.
  bool takes_one(llvm::CallInst& call, const Memory& memory);
  MemoryTie memory_tie(llvm::CallInst& call, llvm::Argument& argument, const Memory& memory);
  ChannelPort channel_port(llvm::CallInst& call, llvm::Value* array, const Memory& memory);
  RegionChannel new_channel(llvm::CallInst& call, llvm::Value* array);
  void tie_to_channel(RegionStream& stream, const Stream& port, llvm::Value* base, uint64_t place);
  int region_stream(llvm::CallInst& call, const Stream& port);
  RegionStream new_region_stream(llvm::Value* base, uint64_t offset, unsigned width);
  /// What feeds a scalar port of an instance: an output of the head, or for the instance's own outputs a port
  /// of the top.
  int region_scalar(llvm::CallInst& call, const Process& process, int index, const std::string& instance);
  /// The place in a local variable that an actual argument is, or was loaded from; null when there is none.
  std::pair<llvm::Value*, uint64_t> local_scalar(llvm::Value* actual, const ScalarPort& port);
  /// The scalar at `port.byte_offset` behind a pointer that an instance takes.
  ValueId pointed_scalar(llvm::CallInst& call, llvm::Value* pointer, const ScalarPort& port);

  const Program& program_;
  const MiddleResult& middle_;
  llvm::Function& function_;
  const llvm::DataLayout& layout_;
  const FunctionInfo* info_ = nullptr;
  llvm::TargetLibraryInfoImpl library_info_;
  llvm::TargetLibraryInfo library_;
  llvm::AssumptionCache assumptions_;
  llvm::DominatorTree dominators_;
  llvm::LoopInfo loops_;
  llvm::ScalarEvolution evolution_;
  Region* region_ = nullptr;
  const std::vector<Process>* region_processes_ = nullptr;
  llvm::CallInst* last_instance_call_ = nullptr;
  std::vector<ValueId> run_values_;  ///< Of a loop's iteration, as Region::run_scalars.
  std::map<std::pair<llvm::Value*, uint64_t>, int> region_streams_;
  std::map<std::pair<llvm::Value*, uint64_t>, int> region_channels_;  ///< By object and place in it.
  /// Local scalars that an instance has set: that instance and its port.
  std::map<std::pair<llvm::Value*, uint64_t>, std::pair<int, int>> region_scalar_writers_;
  Process process_;
  NameTable names_;
  int current_block_ = 0;
  int result_port_ = -1;
  llvm::Value* last_object_pointer_ = nullptr;
  std::map<llvm::Value*, ValueId> values_;
  std::map<std::pair<unsigned, std::string>, ValueId> constants_;
  std::map<std::tuple<int, OpKind, unsigned, unsigned, CompareKind, std::vector<ValueId>>, ValueId> shared_;
  std::map<std::tuple<int, int, ValueId>, ValueId> shared_words_;  ///< Loads of whole elements from ports.
  std::map<llvm::BasicBlock*, int> block_ids_;
  std::map<llvm::Value*, MemoryObject> objects_;
  std::map<std::pair<MemoryObject*, size_t>, ValueId> input_values_;
  std::vector<std::pair<int, ValueId>> entry_copies_;
  std::map<std::pair<llvm::Value*, uint64_t>, int> streams_;
  std::set<int> stream_used_;
};

}  // namespace hlsc

#endif
