#include "middle/stream_queues.h"

#include "middle/primitives.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr uint64_t kDefaultPlaces = 1024;

bool is_stream(const Type* type) {
  auto* structure = dyn_cast<StructType>(type);
  return structure && structure->hasName() && structure->getName().starts_with("class.hls::stream");
}

/// What happens to a stream in one function.
struct StreamUses {
  std::vector<CallInst*> accesses;
  std::vector<Instruction*> births;  ///< Where a local comes to life.
  bool is_known = true;              ///< Nothing else happens to it.
};

void collect_uses(Value* pointer, const Function& function, StreamUses& uses) {
  for (User* user : pointer->users()) {
    auto* instruction = dyn_cast<Instruction>(user);
    auto* gep = dyn_cast<GEPOperator>(user);
    auto* call = dyn_cast<CallInst>(user);
    auto* intrinsic = dyn_cast<IntrinsicInst>(user);
    if (instruction && instruction->getFunction() != &function)
      uses.is_known = false;
    else if (gep && gep->hasAllZeroIndices())
      collect_uses(gep, function, uses);
    else if (intrinsic && intrinsic->getIntrinsicID() == Intrinsic::lifetime_start)
      uses.births.push_back(intrinsic);
    else if (call && primitive_of(*call) != Primitive::kNone)
      uses.accesses.push_back(call);
    else if (!instruction || !(instruction->isLifetimeStartOrEnd() || isa<DbgInfoIntrinsic>(instruction)))
      uses.is_known = false;
  }
}

/// The bits of its elements; 0 when nothing is read or written.
unsigned element_width(const StreamUses& uses) {
  for (CallInst* call : uses.accesses) {
    if (primitive_of(*call) == Primitive::kRead) return call->getType()->getIntegerBitWidth();
    if (primitive_of(*call) == Primitive::kWrite)
      return call->getArgOperand(1)->getType()->getIntegerBitWidth();
  }
  return 0;
}

/// The ring: its elements in whole bytes, the places of the next read and write, and how many elements wait.
class Queue {
 public:
  Queue(Value& stream, unsigned width, uint64_t places) : places_(places) {
    LLVMContext& context = stream.getContext();
    ring_type_ = ArrayType::get(Type::getIntNTy(context, (width + 7) / 8 * 8), places);
    index_type_ = Type::getInt32Ty(context);
    std::string name = stream.getName().str();
    ring_ = object(stream, ring_type_, name);
    first_ = object(stream, index_type_, name + ".first");
    next_ = object(stream, index_type_, name + ".next");
    count_ = object(stream, index_type_, name + ".count");
  }

  void clear(Instruction* before) {
    IRBuilder<> builder(before);
    for (Value* index : {first_, next_, count_}) builder.CreateStore(ConstantInt::get(index_type_, 0), index);
  }

  void replace(CallInst& access) {
    IRBuilder<> builder(&access);
    Value* count = builder.CreateLoad(index_type_, count_);
    switch (primitive_of(access)) {
      case Primitive::kRead: {
        Value* data = builder.CreateLoad(ring_type_->getElementType(), place(builder, first_), "data");
        advance(builder, first_);
        builder.CreateStore(builder.CreateSub(count, ConstantInt::get(index_type_, 1)), count_);
        access.replaceAllUsesWith(builder.CreateTrunc(data, access.getType()));
        break;
      }
      case Primitive::kWrite:
        builder.CreateStore(builder.CreateZExt(access.getArgOperand(1), ring_type_->getElementType()),
                            place(builder, next_));
        advance(builder, next_);
        builder.CreateStore(builder.CreateAdd(count, ConstantInt::get(index_type_, 1)), count_);
        break;
      default: {
        bool asks_empty = primitive_of(access) == Primitive::kEmpty;
        access.replaceAllUsesWith(
            builder.CreateICmpEQ(count, ConstantInt::get(index_type_, asks_empty ? 0 : places_)));
      }
    }
    access.eraseFromParent();
  }

 private:
  /// Beside the stream: a local, or a static object that starts at zero.
  static Value* object(Value& stream, Type* type, const std::string& name) {
    if (auto* global = dyn_cast<GlobalVariable>(&stream))
      return new GlobalVariable(*global->getParent(), type, false, GlobalValue::InternalLinkage,
                                Constant::getNullValue(type), name);
    auto& local = cast<AllocaInst>(stream);
    return new AllocaInst(type, local.getAddressSpace(), name, local.getIterator());
  }

  Value* place(IRBuilder<>& builder, Value* index) {
    Value* at = builder.CreateZExt(builder.CreateLoad(index_type_, index), builder.getInt64Ty());
    return builder.CreateInBoundsGEP(ring_type_, ring_, {builder.getInt64(0), at});
  }

  void advance(IRBuilder<>& builder, Value* index) {
    Value* now = builder.CreateLoad(index_type_, index);
    Value* is_last = builder.CreateICmpEQ(now, ConstantInt::get(index_type_, places_ - 1));
    Value* following = builder.CreateAdd(now, ConstantInt::get(index_type_, 1));
    builder.CreateStore(builder.CreateSelect(is_last, ConstantInt::get(index_type_, 0), following), index);
  }

  uint64_t places_;
  ArrayType* ring_type_;
  Type* index_type_;
  Value *ring_, *first_, *next_, *count_;
};

uint64_t places_of(Value& stream, const StreamUses& uses, const DirectiveTable& directives,
                   Diagnostics& diagnostics) {
  for (const ObjectDirective& entry : directives.of(&stream, "STREAM"))
    if (long depth = entry.directive.integer("depth", 0); depth > 0) return depth;
  diagnostics.warn(nearest_location(*uses.accesses[0]),
                   "this stream is written and read by one process, as a queue in a memory of " +
                       std::to_string(kDefaultPlaces) + " places; give it STREAM depth");
  return kDefaultPlaces;
}

void build_queue(Value& stream, Function& function, const DirectiveTable& directives,
                 Diagnostics& diagnostics) {
  StreamUses uses;
  collect_uses(&stream, function, uses);
  unsigned width = element_width(uses);
  if (!uses.is_known || width == 0) return;
  Queue queue(stream, width, places_of(stream, uses, directives, diagnostics));
  if (auto* local = dyn_cast<AllocaInst>(&stream)) {
    if (uses.births.empty()) uses.births.push_back(&*std::next(local->getIterator()));
    for (Instruction* birth : uses.births) queue.clear(birth);
  }
  for (CallInst* access : uses.accesses) queue.replace(*access);
}

}  // namespace

void build_stream_queues(Module& module, const DirectiveTable& directives, Diagnostics& diagnostics) {
  for (Function& function : module) {
    if (function.isDeclaration() || function_directive(function, "DATAFLOW")) continue;
    std::vector<Value*> streams;
    for (Instruction& instruction : instructions(function))
      if (auto* local = dyn_cast<AllocaInst>(&instruction); local && is_stream(local->getAllocatedType()))
        streams.push_back(local);
    for (GlobalVariable& global : module.globals())
      if (is_stream(global.getValueType())) streams.push_back(&global);
    for (Value* stream : streams) build_queue(*stream, function, directives, diagnostics);
  }
}

}  // namespace hlsc
