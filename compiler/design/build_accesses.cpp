#include <numeric>

#include "design/process_builder.h"
#include "middle/primitives.h"

namespace hlsc {

using namespace llvm;

bool ProcessBuilder::is_store(const Instruction& instruction) {
  auto* call = dyn_cast<CallInst>(&instruction);
  return isa<StoreInst>(instruction) || (call && primitive_of(*call) == Primitive::kStore);
}

ValueId ProcessBuilder::load(Instruction& instruction) {
  Address address = decode(accessed_pointer(instruction), instruction);
  unsigned width = instruction.getType()->getIntegerBitWidth();
  MemoryObject& object = *address.object;
  if (object.is_scalar_port && !object.memories.count({address.leaf, 0}))
    return resized(input_values_[{&object, address.leaf}], width, false, instruction);
  Value* pointer = last_object_pointer_;
  // A load that the program skips does no harm: it needs no predicate and can start early.
  Place place = place_of(address, instruction);
  unsigned memory_width = object.leaves[address.leaf].bytes * 8;
  auto load_bank = [&](uint64_t bank) {
    Operation operation;
    operation.kind = OpKind::kLoad;
    operation.object = memory_of(object, pointer, address.leaf, bank);
    operation.type_width = memory_width;
    operation.operands = {place.address};
    process_.memories[operation.object].is_read = true;
    return add(operation, instruction, process_.memories[operation.object].name + "_data");
  };
  if (object.is_aggregate)
    return resized(load_member(address, place, pointer, instruction), width, false, instruction);
  ValueId loaded;
  if (is_constant(place.bank)) {
    loaded = load_bank(checked_bank(place, object, instruction));
  } else {
    loaded = load_bank(0);
    for (uint64_t bank = 1; bank < place.banks; ++bank) {
      ValueId here = compare(CompareKind::kEq, place.bank, constant_value(APInt(64, bank)), instruction);
      loaded = select(here, load_bank(bank), loaded, instruction);
    }
  }
  return resized(loaded, width, false, instruction);
}

unsigned ProcessBuilder::low_bit(const MemoryObject& object, size_t leaf) {
  return std::accumulate(object.widths.begin(), object.widths.begin() + leaf, 0u);
}

ValueId ProcessBuilder::load_member(const Address& address, const Place& place, Value* pointer,
                                    Instruction& instruction) {
  MemoryObject& object = *address.object;
  int memory = memory_of(object, pointer, 0, 0);
  ValueId& word =
      shared_words_.emplace(std::make_tuple(current_block_, memory, place.address), kNoValue).first->second;
  if (word == kNoValue) {
    Operation operation;
    operation.kind = OpKind::kLoad;
    operation.object = memory;
    operation.type_width = process_.memories[memory].width;
    operation.operands = {place.address};
    process_.memories[memory].is_read = true;
    word = add(operation, instruction, process_.memories[memory].name + "_word");
  }
  unsigned low = low_bit(object, address.leaf), whole = process_[word].type_width;
  ValueId part = low ? binary(OpKind::kLShr, word, constant_value(APInt(whole, low)), instruction) : word;
  part = resized(part, object.widths[address.leaf], false, instruction);
  return resized(part, object.leaves[address.leaf].bytes * 8, object.signedness[address.leaf], instruction);
}

uint64_t ProcessBuilder::checked_bank(const Place& place, const MemoryObject& object,
                                      const Instruction& instruction) {
  uint64_t bank = process_[place.bank].constant.getZExtValue();
  if (bank >= place.banks)
    refuse(instruction, "the subscript is outside of '" + object.name + "'; correct it");
  return bank;
}

ValueId ProcessBuilder::store(Instruction& instruction) {
  Address address = decode(accessed_pointer(instruction), instruction);
  MemoryObject& object = *address.object;
  if (region_ && object.argument >= 0)
    refuse(instruction,
           "'" + object.name +
               "' is written between the processes of a dataflow function; write it in a process");
  Value* pointer = last_object_pointer_;
  auto* call = dyn_cast<CallInst>(&instruction);
  ValueId data = value_of(call ? call->getArgOperand(1) : cast<StoreInst>(instruction).getValueOperand());
  ValueId predicate = call ? predicate_of(call->getArgOperand(2)) : kNoValue;
  if (process_[data].type_width < object.leaves[address.leaf].bytes * 8 &&
      object.leaves[address.leaf].bytes > 1)
    refuse(instruction,
           "this store covers a part of an element of '" + object.name + "'; store the whole element");
  if (object.is_scalar_port) store_output(object, address.leaf, data, predicate, instruction);
  if (object.is_scalar_port && !object.memories.count({address.leaf, 0})) return kNoValue;
  Place place = place_of(address, instruction);
  auto store_bank = [&](uint64_t bank, ValueId condition) {
    Operation operation;
    operation.kind = OpKind::kStore;
    operation.object = memory_of(object, pointer, address.leaf, bank);
    operation.operands = {place.address, data};
    operation.predicate = condition;
    process_.memories[operation.object].is_written = true;
    add(operation, instruction, process_.memories[operation.object].name + "_store");
  };
  if (is_constant(place.bank)) {
    store_bank(checked_bank(place, object, instruction), predicate);
  } else {
    for (uint64_t bank = 0; bank < place.banks; ++bank) {
      ValueId here = compare(CompareKind::kEq, place.bank, constant_value(APInt(64, bank)), instruction);
      store_bank(bank, predicate == kNoValue ? here : binary(OpKind::kAnd, predicate, here, instruction));
    }
  }
  return kNoValue;
}

void ProcessBuilder::store_output(MemoryObject& object, size_t leaf, ValueId data, ValueId predicate,
                                  Instruction& instruction) {
  Operation output;
  output.kind = OpKind::kOutput;
  output.operands = {data};
  output.predicate = predicate;
  output.object = object.outputs[leaf];
  add(output, instruction, object.name + "_set");
}

}  // namespace hlsc
