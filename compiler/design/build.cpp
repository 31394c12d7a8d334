#include "design/process_builder.h"
#include "middle/call_loop.h"
#include "middle/source_location.h"

namespace hlsc {

using namespace llvm;

ProcessBuilder::ProcessBuilder(const Program& program, const MiddleResult& middle,
                               const std::string& function, const std::string& module_name)
    : program_(program),
      middle_(middle),
      function_(*program.module->getFunction(function)),
      layout_(program.module->getDataLayout()),
      library_info_(Triple(program.module->getTargetTriple())),
      library_(library_info_),
      assumptions_(function_),
      dominators_(function_),
      loops_(dominators_),
      evolution_(function_, library_, assumptions_, dominators_, loops_) {
  auto known = program.functions.find(function);
  if (known == program.functions.end())
    throw CompileError("the parameters of '" + module_name +
                       "' have no hardware form; use integers, ap types, structs, arrays of known size and "
                       "hls::stream references");
  info_ = &known->second;
  process_.name = names_.unique(module_name);
  process_.source_name = info_->qualified;
  process_.location = info_->location;
}

Process ProcessBuilder::build() {
  read_parameters();
  find_scalar_port_uses();
  ReversePostOrderTraversal<Function*> order(&function_);
  for (BasicBlock* block : order) {
    block_ids_[block] = process_.blocks.size();
    process_.blocks.emplace_back();
  }
  for (BasicBlock* block : order) build_block(*block);
  for (BasicBlock* block : order) finish_block(*block);
  collect_loops();
  return std::move(process_);
}

void ProcessBuilder::refuse(const Instruction& instruction, const std::string& sentence) {
  throw CompileError(nearest_location(instruction), sentence);
}

void ProcessBuilder::build_block(BasicBlock& block) {
  current_block_ = block_ids_[&block];
  process_.blocks[current_block_].name = names_.unique(block_name(block), "step");
  process_.blocks[current_block_].location = nearest_location(block.front());
  if (current_block_ == 0 && !is_call_loop(function_)) copy_inout_ports();
  read_loop(block);
  for (Instruction& instruction : block) {
    bool begins = process_.blocks[current_block_].takes_calls && &instruction == &*block.getFirstNonPHIIt();
    if (begins) begin_call();
    if (!instruction.isTerminator()) build_instruction(instruction);
  }
  bool ends_run = region_ && region_->is_loop && last_instance_call_->getParent() == &block;
  if (ends_run) write_run(*last_instance_call_);
  if (auto* ret = dyn_cast<ReturnInst>(block.getTerminator()); ret && ret->getReturnValue())
    set_result(returned_value(*ret), *ret);
}

void ProcessBuilder::set_result(ValueId value, const Instruction& source) {
  Operation output;
  output.kind = OpKind::kOutput;
  output.operands = {value};
  output.object = result_port_;
  add(output, source, "result");
}

void ProcessBuilder::begin_call() {
  for (size_t id = 0; id < process_.operations.size(); ++id) {
    if (process_[id].kind != OpKind::kInput) continue;
    process_[id].block = current_block_;
    process_.blocks[current_block_].operations.push_back(id);
  }
  copy_inout_ports();
}

ValueId ProcessBuilder::returned_value(ReturnInst& ret) {
  Value* value = ret.getReturnValue();
  auto* structure = dyn_cast<StructType>(value->getType());
  if (!structure) return value_of(value);
  unsigned width = returned_bits(structure), low = 0;
  ValueId all = constant_value(APInt(width, 0));
  for (unsigned i = 0; i < structure->getNumElements(); ++i) {
    Value* part = FindInsertedValue(value, {i});
    if (!part)
      refuse(ret,
             "this return value has no hardware form; return an integer, an ap type or a struct of them");
    ValueId placed = resized(value_of(part), width, false, ret);
    if (low) placed = binary(OpKind::kShl, placed, constant_value(APInt(width, low)), ret);
    all = is_zero(all) ? placed : binary(OpKind::kOr, all, placed, ret);
    low += part->getType()->getIntegerBitWidth();
  }
  return all;
}

std::string ProcessBuilder::block_name(const BasicBlock& block) {
  return variable_part(block.getName().str());
}

void ProcessBuilder::copy_inout_ports() {
  for (auto [memory, input] : entry_copies_) {
    Operation store;
    store.kind = OpKind::kStore;
    store.object = memory;
    store.operands = {constant_value(APInt(64, 0)), input};
    process_.memories[memory].is_written = true;
    ValueId made = add(store, function_.getEntryBlock().front(), "copy");
    process_[made].location = process_.location;
  }
}

void ProcessBuilder::read_loop(BasicBlock& block) {
  Loop* loop = loops_.getLoopFor(&block);
  if (!loop || loop->getHeader() != &block || loop->getNumBlocks() != 1) return;
  std::optional<Directive> directive = loop_directive(*loop, "PIPELINE");
  if (directive && directive->has("off")) return;
  process_.blocks[current_block_].is_loop = true;
  process_.blocks[current_block_].takes_calls = is_call_loop(function_);
  if (directive) process_.blocks[current_block_].wanted_ii = directive->integer("ii", 1);
  const bool is_unrolled = loop_directive(*loop, "UNROLL").has_value();  // A step is several of the source's.
  for (const Directive& claim : loop_directives(*loop, "DEPENDENCE"))
    if (!is_unrolled || !claim.has("distance"))
      process_.blocks[current_block_].claims.insert(claim.integer(kClaim, -1));
  if (DebugLoc start = loop->getStartLoc()) process_.blocks[current_block_].location = location_of(start);
}

void ProcessBuilder::collect_loops() {
  std::map<const Loop*, int> indices;
  for (Loop* loop : loops_.getLoopsInPreorder()) {
    SourceLoop made = described(*loop);
    auto parent = indices.find(loop->getParentLoop());
    if (parent != indices.end()) made.parent = parent->second;
    indices[loop] = process_.loops.size();
    process_.loops.push_back(made);
  }
}

/// The number of iterations is counted where it is constant, else taken from LOOP_TRIPCOUNT.
SourceLoop ProcessBuilder::described(const Loop& loop) {
  SourceLoop made;
  made.header = block_ids_[loop.getHeader()];
  DebugLoc start = loop.getStartLoc();
  made.location = start ? location_of(start) : process_.blocks[made.header].location;
  if (start) made.name = program_.loop_label(whole_location_of(start));
  if (made.name.empty()) made.name = process_.blocks[made.header].name;
  for (BasicBlock* block : loop.blocks()) made.blocks.push_back(block_ids_[block]);
  if (is_call_loop(function_)) {
    made.least_trips = made.most_trips = 1;  // Of a run, which is a call.
    return made;
  }
  std::optional<Directive> told = loop_directive(loop, "LOOP_TRIPCOUNT");
  made.least_trips = made.most_trips = evolution_.getSmallConstantTripCount(&loop);
  if (!made.most_trips && told) {
    made.least_trips = told->integer("min", 0);
    made.most_trips = told->integer("max", 0);
  }
  if (!made.most_trips) made.most_trips = evolution_.getSmallConstantMaxTripCount(&loop);
  return made;
}

void ProcessBuilder::finish_block(BasicBlock& block) {
  Block& built = process_.blocks[block_ids_[&block]];
  SmallVector<BasicBlock*, 4> sources;
  for (BasicBlock* from : predecessors(&block))
    if (block_ids_.count(from) && !is_contained(sources, from)) sources.push_back(from);
  std::sort(sources.begin(), sources.end(),
            [&](BasicBlock* a, BasicBlock* b) { return block_ids_[a] < block_ids_[b]; });
  for (BasicBlock* from : sources) built.predecessors.push_back(block_ids_[from]);
  for (PHINode& phi : block.phis()) {
    if (!values_.count(&phi)) continue;
    for (BasicBlock* from : sources) {
      ValueId incoming = value_of(phi.getIncomingValueForBlock(from));  // May add a constant.
      process_[values_[&phi]].operands.push_back(incoming);
    }
  }
  built.terminator = terminator_of(*block.getTerminator());
}

Terminator ProcessBuilder::terminator_of(Instruction& instruction) {
  Terminator terminator;
  if (auto* branch = dyn_cast<BranchInst>(&instruction)) {
    terminator.kind = branch->isConditional() ? Terminator::kBranch : Terminator::kJump;
    if (branch->isConditional()) terminator.condition = value_of(branch->getCondition());
    for (unsigned i = 0; i < branch->getNumSuccessors(); ++i)
      terminator.targets.push_back(block_ids_[branch->getSuccessor(i)]);
  } else if (auto* choice = dyn_cast<SwitchInst>(&instruction)) {
    terminator.kind = Terminator::kSwitch;
    terminator.condition = value_of(choice->getCondition());
    terminator.targets.push_back(block_ids_[choice->getDefaultDest()]);
    for (auto& one : choice->cases()) {
      terminator.targets.push_back(block_ids_[one.getCaseSuccessor()]);
      terminator.cases.push_back(one.getCaseValue()->getValue());
    }
  } else if (!isa<ReturnInst>(instruction) && !isa<UnreachableInst>(instruction)) {
    refuse(instruction, "this control flow has no hardware form; use if, switch and loops");
  }
  return terminator;
}

Process build_process(const Program& program, const MiddleResult& middle, const std::string& function,
                      const std::string& module_name) {
  return ProcessBuilder(program, middle, function, module_name).build();
}

Region build_region(const Program& program, const MiddleResult& middle,
                    const std::vector<Process>& processes) {
  const FunctionInfo& top = program.functions.at(program.top);
  return ProcessBuilder(program, middle, program.top, top.name + "_head").build_region(processes);
}

}  // namespace hlsc
