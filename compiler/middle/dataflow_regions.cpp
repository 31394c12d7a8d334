#include "middle/dataflow_regions.h"

#include "frontend/directive.h"
#include "frontend/pragma_handler.h"
#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

bool is_marker(const User* user) {
  auto* call = dyn_cast<CallInst>(user);
  return call && call->getCalledFunction() && call->getCalledFunction()->getName() == kPragmaMarker;
}

std::vector<AllocaInst*> locals_of(Function& function) {
  std::vector<AllocaInst*> locals;
  for (Instruction& instruction : instructions(function))
    if (auto* local = dyn_cast<AllocaInst>(&instruction)) locals.push_back(local);
  return locals;
}

AllocaInst* copy_of(AllocaInst& local, Type* type, unsigned number) {
  auto* copy = new AllocaInst(type, local.getAddressSpace(), local.getName() + "_" + Twine(number),
                              local.getIterator());
  copy->setAlignment(local.getAlign());
  return copy;
}

/// A local that lives several times in straight-line code, as an unrolled iteration's does, becomes one local
/// for each life.
void separate_lives(AllocaInst& local) {
  std::vector<IntrinsicInst*> births;
  BasicBlock* block = nullptr;
  for (User* user : local.users()) {
    auto* instruction = cast<Instruction>(user);
    if (block && instruction->getParent() != block) return;
    block = instruction->getParent();
    auto* intrinsic = dyn_cast<IntrinsicInst>(user);
    if (intrinsic && intrinsic->getIntrinsicID() == Intrinsic::lifetime_start) births.push_back(intrinsic);
  }
  if (births.size() < 2) return;
  AllocaInst* current = nullptr;
  unsigned number = 0;
  for (Instruction& instruction : *block) {
    if (is_contained(births, &instruction))
      current = number++ ? copy_of(local, local.getAllocatedType(), number) : &local;
    if (current && current != &local) instruction.replaceUsesOfWith(&local, current);
  }
}

/// Whether a process takes `local`'s first row where its address is passed, not the whole array.
bool takes_row(const Program& program, const CallInst& call, const AllocaInst& local, uint64_t row_bytes) {
  auto known =
      program.functions.find(call.getCalledFunction() ? call.getCalledFunction()->getName().str() : "");
  if (known == program.functions.end() || known->second.parameters.size() != call.arg_size()) return false;
  for (unsigned i = 0; i < call.arg_size(); ++i) {
    if (call.getArgOperand(i) != &local) continue;
    const Parameter& parameter = known->second.parameters[i];
    uint64_t bytes = parameter.layout.bytes;
    for (uint64_t size : parameter.dims) bytes *= size;
    if (bytes != row_bytes) return false;
  }
  return true;
}

/// The row that a use of `local` means; -1 when it is not one row.
int64_t row_of(const Program& program, const AllocaInst& local, const User* user, uint64_t row_bytes) {
  if (auto* call = dyn_cast<CallInst>(user)) return takes_row(program, *call, local, row_bytes) ? 0 : -1;
  auto* gep = dyn_cast<GEPOperator>(user);
  APInt offset(64, 0);
  if (!gep || !gep->accumulateConstantOffset(local.getDataLayout(), offset) || offset.isNegative()) return -1;
  return offset.urem(row_bytes) == 0 ? offset.udiv(row_bytes).getSExtValue() : -1;
}

/// The marker of the whole for one of its rows: dimensions count from the row's.
void copy_marker(CallInst& marker, AllocaInst& whole, AllocaInst& row) {
  StringRef text;
  getConstantStringInfo(marker.getArgOperand(0), text);
  Directive directive = parse_directive(text.str());
  if (directive.has("dim") || directive.kind == "ARRAY_PARTITION" || directive.kind == "ARRAY_RESHAPE") {
    long dim = directive.integer("dim", 1);
    if (dim == 1) return;  // What the rows are now.
    if (dim > 1) directive.options["dim"] = std::to_string(dim - 1);
  }
  auto* copy = cast<CallInst>(marker.clone());
  IRBuilder<> builder(&marker);
  copy->setArgOperand(0, builder.CreateGlobalString(to_text(directive)));
  copy->insertBefore(&marker);
  copy->replaceUsesOfWith(&whole, &row);
}

void separate_rows(const Program& program, AllocaInst& local) {
  auto* type = dyn_cast<ArrayType>(local.getAllocatedType());
  if (!type || !isa<ArrayType>(type->getElementType())) return;
  uint64_t row_bytes = local.getDataLayout().getTypeAllocSize(type->getElementType());
  std::vector<CallInst*> markers;
  std::vector<std::pair<Instruction*, int64_t>> uses;
  for (User* user : local.users()) {
    auto* instruction = cast<Instruction>(user);
    if (is_marker(user))
      markers.push_back(cast<CallInst>(user));
    else if (!instruction->isLifetimeStartOrEnd())
      uses.push_back({instruction, row_of(program, local, user, row_bytes)});
  }
  for (auto [user, row] : uses)
    if (row < 0 || row >= static_cast<int64_t>(type->getNumElements())) return;
  std::map<int64_t, AllocaInst*> rows;
  for (auto [user, row] : uses) {
    AllocaInst*& object = rows[row];
    if (!object) {
      object = copy_of(local, type->getElementType(), row);
      for (CallInst* marker : markers) copy_marker(*marker, local, *object);
    }
    if (isa<CallInst>(user))
      user->replaceUsesOfWith(&local, object);
    else
      user->replaceAllUsesWith(object);
  }
  for (User* user : make_early_inc_range(local.users())) cast<Instruction>(user)->eraseFromParent();
}

}  // namespace

void separate_region_objects(const Program& program, Function& region) {
  for (AllocaInst* local : locals_of(region)) separate_lives(*local);
  for (AllocaInst* local : locals_of(region)) separate_rows(program, *local);
}

}  // namespace hlsc
