#include "design/process_builder.h"
#include "middle/primitives.h"

namespace hlsc {

using namespace llvm;

ValueId ProcessBuilder::read_stream(CallInst& call) {
  unsigned width = call.getType()->getIntegerBitWidth();
  ValueId data = kNoValue;
  for (const StreamPlace& place : stream_places(call, true, width)) {
    Operation read;
    read.kind = OpKind::kRead;
    read.type_width = width;
    read.predicate = predicate_at(call.getArgOperand(1), place, call);
    read.object = place.stream;
    process_.streams[place.stream].is_lock |= is_lock(call);
    ValueId one = add(read, call, process_.streams[place.stream].name + "_data");
    data = data == kNoValue ? one : select(place.condition, one, data, call);
  }
  return data;
}

void ProcessBuilder::write_stream(CallInst& call) {
  ValueId data = value_of(call.getArgOperand(1));
  for (const StreamPlace& place :
       stream_places(call, false, call.getArgOperand(1)->getType()->getIntegerBitWidth())) {
    Operation write;
    write.kind = OpKind::kWrite;
    write.operands = {data};
    write.predicate = predicate_at(call.getArgOperand(2), place, call);
    write.object = place.stream;
    process_.streams[place.stream].is_lock |= is_lock(call);
    add(write, call, process_.streams[place.stream].name + "_write");
  }
}

ValueId ProcessBuilder::stream_status(CallInst& call) {
  bool asks_empty = primitive_of(call) == Primitive::kEmpty;
  ValueId answer = kNoValue;
  for (const StreamPlace& place : stream_places(call, asks_empty, 0)) {
    Operation status;
    status.kind = asks_empty ? OpKind::kEmpty : OpKind::kFull;
    status.type_width = 1;
    status.object = place.stream;
    ValueId one = add(status, call, process_.streams[place.stream].name + (asks_empty ? "_empty" : "_full"));
    answer = answer == kNoValue ? one : select(place.condition, one, answer, call);
  }
  return answer;
}

ValueId ProcessBuilder::predicate_at(Value* predicate, const StreamPlace& place, CallInst& call) {
  ValueId own = predicate_of(predicate);
  if (own == kNoValue || place.condition == kNoValue) return own == kNoValue ? place.condition : own;
  return binary(OpKind::kAnd, own, place.condition, call);
}

std::vector<ProcessBuilder::StreamPlace> ProcessBuilder::stream_places(CallInst& call, bool is_input,
                                                                       unsigned width) {
  if (region_)
    refuse(call,
           "this access to a stream stands between the processes of a dataflow function; move it into a "
           "function of its own");
  std::vector<StreamPlace> places;
  find_streams(call.getArgOperand(0), kNoValue, call, places);
  for (const StreamPlace& place : places) {
    Stream& stream = process_.streams[place.stream];
    if (stream_used_.insert(place.stream).second)
      stream.is_input = is_input;
    else if (stream.is_input != is_input)
      refuse(call, "stream '" + stream.name +
                       "' is both read and written by one process; use a local array, or split the process");
    if (width) stream.width = width;
  }
  return places;
}

void ProcessBuilder::find_streams(Value* pointer, ValueId condition, CallInst& call,
                                  std::vector<StreamPlace>& places) {
  if (auto* choice = dyn_cast<SelectInst>(pointer)) {
    ValueId yes = value_of(choice->getCondition());
    ValueId no = binary(OpKind::kXor, yes, constant_value(APInt(1, 1)), call);
    auto and_also = [&](ValueId arm) {
      return condition == kNoValue ? arm : binary(OpKind::kAnd, condition, arm, call);
    };
    find_streams(choice->getTrueValue(), and_also(yes), call, places);
    find_streams(choice->getFalseValue(), and_also(no), call, places);
    return;
  }
  APInt constant(64, 0);
  MapVector<Value*, APInt> terms;
  Value* base = pointer;
  while (auto* gep = dyn_cast<GEPOperator>(base)) {
    if (!gep->collectOffset(layout_, 64, terms, constant)) break;
    base = gep->getPointerOperand();
  }
  if (isa<GlobalVariable>(base) && terms.empty()) add_global_stream(base, constant.getZExtValue());
  size_t known = places.size();
  for (auto& [key, stream] : streams_) {
    if (key.first != base) continue;
    APInt rest = APInt(64, key.second) - constant;
    if (terms.empty() && !rest.isZero()) continue;
    ValueId here = condition;
    if (!terms.empty()) {
      ValueId same = subscripts_lead_to(terms, rest, call);
      if (same == kNoValue) continue;
      here = here == kNoValue ? same : binary(OpKind::kAnd, here, same, call);
    }
    places.push_back({stream, here});
  }
  if (places.size() > known) return;
  if (isa<AllocaInst>(base) || isa<GlobalVariable>(base))
    refuse(call,
           "stream '" + object_name(base) +
               "' stays inside one process; put #pragma HLS DATAFLOW into the function that declares it "
               "and its writer and reader into functions of their own, or use an array");
  refuse(call, "cannot tell which stream is meant here; pass streams by reference and use subscripts");
}

void ProcessBuilder::add_global_stream(Value* base, uint64_t offset) {
  bool is_alone = middle_.processes.size() == 1;  // Nobody is at its other end.
  if (is_alone || streams_.count({base, offset})) return;
  streams_[{base, offset}] = process_.streams.size();
  Stream stream;
  stream.name = names_.unique(object_name(base), "stream");
  stream.byte_offset = offset;
  stream.global = base->getName().str();
  process_.streams.push_back(stream);
}

ValueId ProcessBuilder::subscripts_lead_to(const MapVector<Value*, APInt>& terms, const APInt& rest,
                                           CallInst& call) {
  if (terms.size() == 1) {
    const auto& [subscript, stride] = terms.front();
    if (rest.srem(stride) != 0) return kNoValue;
    APInt element = rest.sdiv(stride);
    unsigned width = subscript->getType()->getIntegerBitWidth();
    if (!element.isSignedIntN(width)) return kNoValue;
    return compare(CompareKind::kEq, value_of(subscript), constant_value(element.sextOrTrunc(width)), call);
  }
  ValueId offset = constant_value(APInt(64, 0));
  for (auto& [subscript, stride] : terms) {
    ValueId term =
        binary(OpKind::kMul, resized(value_of(subscript), 64, true, call), constant_value(stride), call);
    offset = is_zero(offset) ? term : binary(OpKind::kAdd, offset, term, call);
  }
  return compare(CompareKind::kEq, offset, constant_value(rest), call);
}

}  // namespace hlsc
