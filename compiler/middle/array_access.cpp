#include "middle/array_access.h"

#include <llvm/ADT/SetVector.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>

#include "middle/llvm_headers.h"
#include "middle/primitives.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr const char* kElementPrefix = "hls.element";

void collect_leaves(const DataLayout& layout, Type* type, MemoryLeaf leaf, std::vector<MemoryLeaf>& leaves) {
  if (auto* array = dyn_cast<ArrayType>(type)) {
    leaf.dims.push_back(array->getNumElements());
    leaf.strides.push_back(layout.getTypeAllocSize(array->getElementType()));
    collect_leaves(layout, array->getElementType(), leaf, leaves);
  } else if (auto* structure = dyn_cast<StructType>(type)) {
    for (unsigned i = 0; i < structure->getNumElements(); ++i) {
      MemoryLeaf member = leaf;
      if (structure->getNumElements() > 1) member.path += "_" + std::to_string(i);
      member.byte_offset += layout.getStructLayout(structure)->getElementOffset(i);
      collect_leaves(layout, structure->getElementType(i), member, leaves);
    }
  } else {
    leaf.bytes = layout.getTypeStoreSize(type);
    leaves.push_back(leaf);
  }
}

/// Arrays at two levels with a struct between them, where one byte offset may name several leaves.
bool is_irregular(Type* type) {
  while (auto* array = dyn_cast<ArrayType>(type)) type = array->getElementType();
  auto* structure = dyn_cast<StructType>(type);
  if (!structure) return false;
  return any_of(structure->elements(), [](Type* element) {
    return isa<ArrayType>(element) || is_irregular(element) ||
           (isa<StructType>(element) && is_irregular(element));
  });
}

/// Handles of streams and tasks have places, but no contents.
bool holds_streams(Type* type) {
  while (auto* array = dyn_cast<ArrayType>(type)) type = array->getElementType();
  auto* structure = dyn_cast<StructType>(type);
  if (!structure) return false;
  StringRef name = structure->hasName() ? structure->getName() : "";
  if (name.starts_with("class.hls::stream") || name.starts_with("class.hls::task")) return true;
  return structure->getNumElements() && all_of(structure->elements(), holds_streams);
}

Type* object_type(Value* object) {
  if (auto* alloca = dyn_cast<AllocaInst>(object)) return alloca->getAllocatedType();
  if (auto* global = dyn_cast<GlobalVariable>(object)) return global->getValueType();
  return nullptr;
}

class SubscriptSeparator {
 public:
  SubscriptSeparator(Value* object, Type* type, const DataLayout& layout)
      : object_(object), layout_(layout), leaves_(memory_leaves(layout, type)) {}

  void run() { follow(object_, {}); }

 private:
  /// A byte offset as a constant plus scaled values.
  struct Offset {
    int64_t constant = 0;
    std::vector<std::pair<Value*, int64_t>> terms;   ///< value * bytes
    std::vector<std::pair<int64_t, int64_t>> steps;  ///< constant subscript * bytes
  };

  void follow(Value* pointer, const Offset& offset) {
    // In the order of use, not of addresses: the same source gives the same bytes.
    SmallSetVector<User*, 16> users(pointer->user_begin(), pointer->user_end());
    for (User* user : users) {
      auto* instruction = dyn_cast<Instruction>(user);
      if (!instruction) {
        follow_constant(user, offset);
      } else if (auto* gep = dyn_cast<GetElementPtrInst>(instruction)) {
        follow(gep, extended(offset, *cast<GEPOperator>(gep)));
      } else if (isa<LoadInst>(instruction) || isa<StoreInst>(instruction)) {
        rewrite(*instruction, pointer, offset);
      } else if (auto* call = dyn_cast<CallInst>(instruction);
                 call && primitive_of(*call) != Primitive::kNone) {
        continue;  // A stream that the object holds.
      } else if (!isa<DbgInfoIntrinsic>(instruction) && !instruction->isLifetimeStartOrEnd()) {
        throw CompileError(nearest_location(*instruction),
                           "a pointer into '" + object_->getName().str() +
                               "', which is partitioned or holds arrays in structs, is used here as a value; "
                               "use subscripts of the array itself");
      }
    }
  }

  void follow_constant(User* user, const Offset& offset) {
    if (auto* gep = dyn_cast<GEPOperator>(user)) follow(user, extended(offset, *gep));
  }

  Offset extended(Offset offset, const GEPOperator& gep) {
    for (auto type = gep_type_begin(gep); type != gep_type_end(gep); ++type) {
      Value* index = type.getOperand();
      if (StructType* structure = type.getStructTypeOrNull()) {
        offset.constant +=
            layout_.getStructLayout(structure)->getElementOffset(cast<ConstantInt>(index)->getZExtValue());
        continue;
      }
      int64_t stride = layout_.getTypeAllocSize(type.getIndexedType());
      if (auto* constant = dyn_cast<ConstantInt>(index))
        offset.steps.push_back({constant->getSExtValue(), stride});
      else
        offset.terms.push_back({index, stride});
    }
    return offset;
  }

  /// The leaf an access falls in: the one whose dimensions have the strides of all variable subscripts and
  /// whose offset matches.
  const MemoryLeaf* leaf_of(const Offset& offset, std::vector<int64_t>& constants) {
    // Offsets inside a leaf come first; only then one that counts on a subscript to bring it back.
    const MemoryLeaf* leaf = leaf_of(offset, constants, true);
    return leaf ? leaf : leaf_of(offset, constants, false);
  }

  const MemoryLeaf* leaf_of(const Offset& offset, std::vector<int64_t>& constants, bool is_strict) {
    for (const MemoryLeaf& leaf : leaves_) {
      constants.assign(leaf.dims.size(), 0);
      int64_t member = offset.constant;
      bool fits = true;
      for (auto [step, stride] : offset.steps) {
        auto place = find(leaf.strides, static_cast<uint64_t>(stride));
        // Steps of one byte may be plain offsets to a member; they are told apart below.
        if (stride > 1 && place != leaf.strides.end())
          constants[place - leaf.strides.begin()] += step;
        else if (step != 0)
          member += step * stride;  // An i8 address: LLVM or our own lowering made it.
      }
      for (auto [value, stride] : offset.terms)
        fits &= is_contained(leaf.strides, static_cast<uint64_t>(stride));
      if (!fits) continue;
      // What is left of a byte address may hold whole constant subscripts.
      int64_t rest = member - static_cast<int64_t>(leaf.byte_offset);
      for (size_t d = 0; d < leaf.dims.size() && rest >= 0; ++d) {
        int64_t stride = leaf.strides[d];
        int64_t whole = rest / stride;
        bool is_bound = d > 0 || is_strict;
        if (is_bound && whole >= static_cast<int64_t>(leaf.dims[d])) break;  // Behind this leaf.
        constants[d] += whole;
        rest %= stride;
      }
      bool counts_bytes = leaves_.size() == 1 && !leaf.strides.empty() && leaf.strides.back() == 1;
      counts_bytes &= !is_strict;
      if (rest < 0 && counts_bytes) constants.back() += rest;
      if (rest == 0 || counts_bytes) return &leaf;
    }
    return nullptr;
  }

  void rewrite(Instruction& access, Value* pointer, Offset offset) {
    if (auto* store = dyn_cast<StoreInst>(&access); store && isa<UndefValue>(store->getValueOperand())) {
      store->eraseFromParent();  // Padding between members.
      return;
    }
    std::vector<int64_t> constants;
    const MemoryLeaf* leaf = leaf_of(offset, constants);
    if (!leaf)
      throw CompileError(nearest_location(access), "cannot tell which member of '" +
                                                       object_->getName().str() +
                                                       "' is meant here; use plain subscripts");
    IRBuilder<> builder(&access);
    std::vector<Value*> arguments = {object_, builder.getInt64(leaf->byte_offset)};
    for (size_t d = 0; d < leaf->dims.size(); ++d) {
      Value* index = builder.getInt64(constants[d]);
      for (auto [value, stride] : offset.terms)
        if (static_cast<uint64_t>(stride) == leaf->strides[d])
          index = builder.CreateNSWAdd(builder.CreateSExtOrTrunc(value, builder.getInt64Ty()), index);
      arguments.push_back(index);
    }
    std::vector<Type*> types = {builder.getPtrTy()};
    types.resize(arguments.size(), builder.getInt64Ty());
    FunctionCallee callee =
        access.getModule()->getOrInsertFunction(kElementPrefix + std::to_string(leaf->dims.size()),
                                                FunctionType::get(builder.getPtrTy(), types, false));
    auto* function = cast<Function>(callee.getCallee());
    function->setDoesNotAccessMemory();
    function->setDoesNotThrow();
    function->addFnAttr(Attribute::WillReturn);
    function->addFnAttr(Attribute::Speculatable);
    access.replaceUsesOfWith(pointer, builder.CreateCall(callee, arguments));
  }

  Value* object_;
  const DataLayout& layout_;
  std::vector<MemoryLeaf> leaves_;
};

bool lies_between_processes(const Value& object) {
  return any_of(object.users(), [](const User* user) {
    auto* call = dyn_cast<CallInst>(user);
    return call && call->getCalledFunction() && !call->getCalledFunction()->isDeclaration();
  });
}

/// Warns of the partition of an array between processes, which is one memory.
bool wants_separation(Value* object, Type* type, const DirectiveTable& directives, Diagnostics& diagnostics) {
  if (holds_streams(type)) return false;
  if (is_irregular(type)) return !lies_between_processes(*object);
  std::vector<ObjectDirective> partitions = directives.of(object, "ARRAY_PARTITION");
  if (!partitions.empty() && lies_between_processes(*object)) {
    diagnostics.warn(partitions[0].location,
                     "ARRAY_PARTITION of '" + object->getName().str() +
                         "' has no effect: it lies between two processes, as one memory");
    return false;
  }
  return !partitions.empty();
}

bool has_variable_subscript(const Value& pointer) {
  return any_of(pointer.users(), [](const User* user) {
    auto* gep = dyn_cast<GEPOperator>(user);
    return gep && (!gep->hasAllConstantIndices() || has_variable_subscript(*gep));
  });
}

/// hls::stream_of_blocks.
bool is_block_channel(const Type* type) {
  auto* structure = dyn_cast_or_null<StructType>(type);
  return structure && structure->hasName() && structure->getName().starts_with("class.hls::stream_of_blocks");
}

/// The type behind a parameter that is one struct with arrays (or its lone array) and is accessed with
/// subscripts of its members alone; null for other parameters.
Type* struct_with_arrays(const Program& program, Argument& argument) {
  auto function = program.functions.find(argument.getParent()->getName().str());
  if (function == program.functions.end()) return nullptr;
  bool is_one = any_of(function->second.parameters, [&](const Parameter& parameter) {
    bool may_be_one = parameter.dims.empty() || (parameter.dims.size() == 1 && parameter.dims[0] == 0);
    const TypeLayout& layout = parameter.streams.empty() ? parameter.layout : parameter.members;
    return argument.getName() == parameter.name && may_be_one && layout.leaves.size() > 1;
  });
  if (!is_one) return nullptr;
  Type *structure = nullptr, *array = nullptr;  // The array: the first member, whose address is the struct's.
  for (User* user : argument.users()) {
    auto* gep = dyn_cast<GEPOperator>(user);
    Type* source = gep ? gep->getSourceElementType() : nullptr;
    if (!source || !source->isAggregateType()) continue;
    auto* first = dyn_cast<ConstantInt>(gep->getOperand(1));
    Type*& known = source->isStructTy() ? structure : array;
    if (!first || !first->isZero() || (known && known != source)) return nullptr;
    known = source;
  }
  if (!is_block_channel(structure) && !has_variable_subscript(argument)) return nullptr;
  return structure && is_irregular(structure) ? structure : structure ? nullptr : array;
}

std::vector<Value*> objects_of(Module& module) {
  std::vector<Value*> objects;
  for (GlobalVariable& global : module.globals()) objects.push_back(&global);
  for (Function& function : module)
    for (Instruction& instruction : instructions(function))
      if (isa<AllocaInst>(instruction)) objects.push_back(&instruction);
  return objects;
}

}  // namespace

std::vector<MemoryLeaf> memory_leaves(const DataLayout& layout, Type* type) {
  std::vector<MemoryLeaf> leaves;
  collect_leaves(layout, type, {}, leaves);
  return leaves;
}

bool is_element_address(const Value* value) {
  auto* call = dyn_cast<CallInst>(value);
  return call && call->getCalledFunction() &&
         call->getCalledFunction()->getName().starts_with(kElementPrefix);
}

void separate_subscripts(const Program& program, const DirectiveTable& directives, Diagnostics& diagnostics) {
  Module& module = *program.module;
  for (Value* object : objects_of(module))
    if (Type* type = object_type(object);
        type && type->isAggregateType() && wants_separation(object, type, directives, diagnostics))
      SubscriptSeparator(object, type, module.getDataLayout()).run();
  for (Function& function : module)
    for (Argument& argument : function.args())
      if (Type* type = struct_with_arrays(program, argument))
        SubscriptSeparator(&argument, type, module.getDataLayout()).run();
}

void dissolve_constant_subscripts(Value& object) {
  std::vector<CallInst*> calls;
  for (User* user : object.users()) {
    if (!is_element_address(user)) continue;
    calls.push_back(cast<CallInst>(user));
    for (unsigned i = 2; i < calls.back()->arg_size(); ++i)
      if (!isa<ConstantInt>(calls.back()->getArgOperand(i))) return;
  }
  if (calls.empty()) return;
  std::vector<MemoryLeaf> leaves = memory_leaves(calls[0]->getDataLayout(), object_type(&object));
  for (CallInst* call : calls) {
    uint64_t offset = cast<ConstantInt>(call->getArgOperand(1))->getZExtValue();
    auto leaf = find_if(leaves, [&](const MemoryLeaf& one) { return one.byte_offset == offset; });
    for (unsigned d = 0; d + 2 < call->arg_size(); ++d)
      offset += leaf->strides[d] * cast<ConstantInt>(call->getArgOperand(d + 2))->getSExtValue();
    IRBuilder<> builder(call);
    call->replaceAllUsesWith(builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), &object, offset));
    call->eraseFromParent();
  }
}

void dissolve_constant_subscripts(Module& module) {
  for (Value* object : objects_of(module))
    if (isa<AllocaInst>(object)) dissolve_constant_subscripts(*object);
}

}  // namespace hlsc
