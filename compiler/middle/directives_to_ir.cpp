#include "middle/directives_to_ir.h"

#include <set>

#include "frontend/pragma_handler.h"
#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr const char* kLoopTag = "hls.directive";

/// Directives on a loop or a function; the others need a variable or a port.
const std::set<std::string> kRegionKinds = {"PIPELINE",   "UNROLL", "DATAFLOW",     "LOOP_TRIPCOUNT",
                                            "DEPENDENCE", "INLINE", "LOOP_FLATTEN", "LATENCY"};
const std::set<std::string> kObjectKinds = {
    "ARRAY_PARTITION", "ARRAY_RESHAPE", "BIND_STORAGE",        "RESOURCE",
    "STREAM",          "DEPENDENCE",    "AGGREGATE",           "DISAGGREGATE",
    "DATA_PACK",       "STABLE",        "FUNCTION_INSTANTIATE"};

/// Accepted, because they change neither results nor handshakes, but without effect.
const std::set<std::string> kIgnoredKinds = {"ALLOCATION", "ARRAY_MAP",  "BIND_OP",     "EXPRESSION_BALANCE",
                                             "LOOP_MERGE", "OCCURRENCE", "PERFORMANCE", "PROTOCOL",
                                             "RESET",      "SHARED",     "TOP"};

/// Behind a pointer with m_axi whose size nothing tells, as the bus reaches all of a memory.
constexpr unsigned kBusElements = 1u << 20;

struct Marker {
  CallInst* call;
  Directive directive;
  std::string variable_name;
  Value* variable;  ///< Null without one.
};

std::string string_argument(const CallInst& call, unsigned index) {
  StringRef text;
  if (!getConstantStringInfo(call.getArgOperand(index), text)) return "";
  return text.str();
}

Marker read_marker(CallInst& call) {
  Marker marker{&call, parse_directive(string_argument(call, 0)), string_argument(call, 1),
                call.getArgOperand(2)};
  if (isa<ConstantPointerNull>(marker.variable)) marker.variable = nullptr;
  for (auto& [key, value] : marker.directive.options) {
    if (value.empty() || value[0] != '$') continue;
    auto* number = dyn_cast<ConstantInt>(call.getArgOperand(3 + std::stoul(value.substr(1))));
    if (!number)
      throw CompileError(
          location_of(call),
          "'" + key +
              "' of the pragma must be a constant; give a literal, a constexpr or a template parameter");
    value = std::to_string(number->getSExtValue());
  }
  return marker;
}

std::vector<Marker> markers_of(Function& function) {
  std::vector<Marker> markers;
  for (Instruction& instruction : instructions(function))
    if (auto* call = dyn_cast<CallInst>(&instruction))
      if (call->getCalledFunction() && call->getCalledFunction()->getName() == kPragmaMarker)
        markers.push_back(read_marker(*call));
  return markers;
}

MDNode* string_node(LLVMContext& context, ArrayRef<std::string> words) {
  SmallVector<Metadata*, 4> parts;
  for (const std::string& word : words) parts.push_back(MDString::get(context, word));
  return MDNode::get(context, parts);
}

/// The directive that an operand of a loop's metadata holds, if any.
std::optional<Directive> directive_of(const Metadata* operand) {
  auto* node = dyn_cast<MDNode>(operand);
  if (!node || node->getNumOperands() != 2) return std::nullopt;
  auto* tag = dyn_cast<MDString>(node->getOperand(0));
  if (!tag || tag->getString() != kLoopTag) return std::nullopt;
  return parse_directive(cast<MDString>(node->getOperand(1))->getString().str());
}

void add_loop_metadata(Loop& loop, ArrayRef<Metadata*> extra) {
  LLVMContext& context = loop.getHeader()->getContext();
  SmallVector<Metadata*, 8> parts = {nullptr};
  if (MDNode* old = loop.getLoopID()) parts.append(old->op_begin() + 1, old->op_end());
  parts.append(extra.begin(), extra.end());
  MDNode* id = MDNode::getDistinct(context, parts);
  id->replaceOperandWith(0, id);
  loop.setLoopID(id);
}

MDNode* unroll_node(LLVMContext& context, const Directive& directive) {
  long factor = directive.integer("factor", 0);
  if (factor == 0) return string_node(context, {"llvm.loop.unroll.full"});
  if (factor == 1) return string_node(context, {"llvm.loop.unroll.disable"});
  Metadata* count = ConstantAsMetadata::get(ConstantInt::get(Type::getInt32Ty(context), factor));
  return MDNode::get(context, {MDString::get(context, "llvm.loop.unroll.count"), count});
}

bool asks_for_pipeline(const Directive& directive) {
  return directive.kind == "PIPELINE" && !directive.has("off");
}

void attach_to_loop(Loop& loop, const Directive& directive);

/// All of them but `except` and those that say themselves how they are unrolled.
void unroll_loops(ArrayRef<Loop*> loops, const Loop* except = nullptr) {
  for (Loop* loop : loops)
    if (loop != except && !loop_directive(*loop, "UNROLL"))
      attach_to_loop(*loop, parse_directive("UNROLL implied"));
}

void attach_to_loop(Loop& loop, const Directive& directive) {
  LLVMContext& context = loop.getHeader()->getContext();
  SmallVector<Metadata*, 2> nodes = {string_node(context, {kLoopTag, to_text(directive)})};
  if (directive.kind == "UNROLL") nodes.push_back(unroll_node(context, directive));
  add_loop_metadata(loop, nodes);
  if (asks_for_pipeline(directive)) unroll_loops(loop.getLoopsInPreorder(), &loop);
}

void attach_to_function(Function& function, LoopInfo& loops, const Directive& directive) {
  std::string name = "hls-" + StringRef(directive.kind).lower();
  function.addFnAttr(name, to_text(directive));
  if (asks_for_pipeline(directive)) unroll_loops(loops.getLoopsInPreorder());
}

bool is_real(const Value* value) { return value->getType()->isFloatingPointTy(); }

/// Whether a loop calculates with real numbers that come from its counters alone, as one that fills a table
/// does.
bool counts_in_reals(const Loop& loop) {
  bool found = false;
  for (BasicBlock* block : loop.blocks())
    for (Instruction& instruction : *block) {
      bool takes_real =
          any_of(instruction.operands(), [](const Use& use) { return is_real(use) && isa<Argument>(use); });
      if (takes_real || (isa<LoadInst>(instruction) && is_real(&instruction))) return false;
      found |= is_real(&instruction);
    }
  return found;
}

/// What is stored in a local variable that holds a pointer; null for another object.
Value* stored_pointer(Value* object) {
  auto* alloca = dyn_cast<AllocaInst>(object);
  if (!alloca || !alloca->getAllocatedType()->isPointerTy()) return nullptr;
  for (User* user : alloca->users())
    if (auto* store = dyn_cast<StoreInst>(user); store && store->getPointerOperand() == alloca)
      return store->getValueOperand();
  return nullptr;
}

/// The pointer behind references and array parameters, which are kept in memory.
Value* without_references(Value* pointer) {
  Value* object = getUnderlyingObject(pointer, 0);
  if (auto* load = dyn_cast<LoadInst>(object)) object = load->getPointerOperand();
  Value* stored = stored_pointer(object);
  return stored ? without_references(stored) : pointer;
}

/// The member at a byte offset of a struct, or of structs in it; null when there is none.
Type* member_at(StructType& structure, uint64_t offset, const DataLayout& layout) {
  const StructLayout& members = *layout.getStructLayout(&structure);
  if (offset >= members.getSizeInBytes()) return nullptr;
  unsigned index = members.getElementContainingOffset(offset);
  Type* member = structure.getElementType(index);
  offset -= members.getElementOffset(index);
  if (offset == 0) return member;
  auto* inner = dyn_cast<StructType>(member);
  return inner ? member_at(*inner, offset, layout) : nullptr;
}

/// The type of what a pragma names at a byte offset of `object`; null when only the caller of the top knows.
Type* named_type(Value* pointer, Value* object, uint64_t offset, const DataLayout& layout) {
  if (auto* alloca = dyn_cast<AllocaInst>(pointer)) return alloca->getAllocatedType();
  if (auto* global = dyn_cast<GlobalVariable>(pointer)) return global->getValueType();
  auto* gep = dyn_cast<GEPOperator>(pointer);
  if (!gep) return nullptr;
  // LLVM turns the address of a global object's member into one in bytes.
  auto* global = dyn_cast<GlobalVariable>(object);
  auto* structure = global ? dyn_cast<StructType>(global->getValueType()) : nullptr;
  Type* member = structure ? member_at(*structure, offset, layout) : nullptr;
  return member ? member : gep->getResultElementType();
}

/// The object of a pragma and the part of it that is named. A struct as a whole has no subscripts: its first
/// member is meant, which has the same address.
ObjectDirective object_directive(const Marker& marker) {
  Value* pointer = without_references(marker.variable);
  const DataLayout& layout = marker.call->getDataLayout();
  ObjectDirective made;
  made.object = getUnderlyingObject(pointer, 0);
  made.directive = marker.directive;
  made.location = location_of(*marker.call);
  APInt offset(64, 0);
  pointer->stripAndAccumulateConstantOffsets(layout, offset, /*AllowNonInbounds=*/true);
  made.offset = offset.getZExtValue();
  Type* type = named_type(pointer, made.object, made.offset, layout);
  for (auto* structure = dyn_cast_or_null<StructType>(type); structure && structure->getNumElements();
       structure = dyn_cast<StructType>(type))
    type = structure->getElementType(0);
  if (!type || !type->isSized()) return made;
  made.bytes = layout.getTypeAllocSize(type);
  for (; isa<ArrayType>(type); type = type->getArrayElementType()) ++made.dims;
  return made;
}

/// Why a directive does nothing for a local object; empty when it does.
std::string misuse_of(const std::string& kind, Value* object, Function& function) {
  auto* local = dyn_cast<AllocaInst>(object);
  if (!local) return "";
  Type* type = local->getAllocatedType();
  if (StringRef(kind).starts_with("ARRAY_") && type->isIntegerTy()) return "is no array";
  bool is_stream =
      isa<StructType>(type) || (type->isArrayTy() && isa<StructType>(type->getArrayElementType()));
  if (kind == "STREAM" && !is_stream && !function_directive(function, "DATAFLOW"))
    return "is no stream; declare it as hls::stream";
  return "";
}

/// Refuses numbers that mean nothing.
void check_numbers(const Directive& directive, const SourceLocation& where) {
  for (const char* option : {"factor", "depth", "ii", "dim", "distance"}) {
    if (!directive.has(option)) continue;
    long value = 0;
    try {
      value = directive.integer(option, 0);
    } catch (const std::invalid_argument&) {
      throw CompileError(where, "'" + directive.text(option) + "' is no number for " + option +
                                    " of pragma '" + directive.kind + "'; write an integer constant");
    }
    bool takes_zero = std::string(option) == "dim" || std::string(option) == "depth";
    if (value < (takes_zero ? 0 : 1))
      throw CompileError(where, std::string(option) + " of pragma '" + directive.kind +
                                    "' must be at least " + (takes_zero ? "0" : "1"));
  }
}

bool is_bus_master(const Directive& interface) {
  return interface.has("m_axi") || interface.text("mode") == "m_axi";
}

/// Notes in a DEPENDENCE and in the loops that it stands in the number by which these know it.
void mark_claim(Marker& marker, LoopInfo& loops, size_t number) {
  Loop* around = loops.getLoopFor(marker.call->getParent());
  if (!around) return;
  marker.directive.options[kClaim] = std::to_string(number);
  for (Loop* loop : around->getLoopsInPreorder()) attach_to_loop(*loop, marker.directive);
}

}  // namespace

std::vector<ObjectDirective> DirectiveTable::of(const Value* object, const std::string& kind) const {
  std::vector<ObjectDirective> found;
  for (const ObjectDirective& entry : objects)
    if (entry.object == object && entry.directive.kind == kind) found.push_back(entry);
  return found;
}

void resolve_loop_directives(Module& module, DirectiveTable& table, Diagnostics& diagnostics) {
  for (Function& function : module) {
    if (function.isDeclaration()) continue;
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    for (Marker& marker : markers_of(function)) {
      const std::string& kind = marker.directive.kind;
      SourceLocation where = location_of(*marker.call);
      check_numbers(marker.directive, where);
      if (kind == "INTERFACE") {
        if (is_bus_master(marker.directive))
          marker.directive.options.emplace("depth", std::to_string(kBusElements));
        table.ports[function.getName().str()].push_back(
            {marker.variable_name.empty() && marker.directive.has("port") ? "return" : marker.variable_name,
             marker.directive, where});
        marker.call->eraseFromParent();
        continue;
      }
      bool is_ignored =
          kIgnoredKinds.count(kind) || (kind == "LATENCY" && loops.getLoopFor(marker.call->getParent()));
      if (is_ignored) {
        bool asks_nothing = kind == "EXPRESSION_BALANCE" && marker.directive.has("off");
        if (!asks_nothing)
          diagnostics.warn(where,
                           "pragma '" + kind + "' has no effect here; results are the same without it");
        marker.call->eraseFromParent();
        continue;
      }
      if (marker.variable) {
        if (kObjectKinds.count(kind)) continue;
        diagnostics.warn(where, "pragma '" + kind + "' is not known and has no effect");
      } else if (kRegionKinds.count(kind)) {
        Loop* loop = loops.getLoopFor(marker.call->getParent());
        if (loop && kind != "DATAFLOW")
          attach_to_loop(*loop, marker.directive);
        else if (kind == "UNROLL" || kind == "LOOP_TRIPCOUNT" || kind == "LOOP_FLATTEN")
          diagnostics.warn(where, "pragma '" + kind +
                                      "' stands in no loop and has no effect; move it into the body of one");
        else
          attach_to_function(function, loops, marker.directive);
      } else {
        diagnostics.warn(where, kObjectKinds.count(kind)
                                    ? "pragma '" + kind + "' needs variable=NAME and has no effect without it"
                                    : "pragma '" + kind + "' is not known and has no effect");
      }
      marker.call->eraseFromParent();
    }
  }
}

void unroll_inlined_loops(Module& module) {
  for (Function& function : module) {
    if (function.isDeclaration()) continue;
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    for (Loop* loop : loops.getLoopsInPreorder()) {
      std::optional<Directive> pipeline = loop_directive(*loop, "PIPELINE");
      if (pipeline && asks_for_pipeline(*pipeline)) unroll_loops(loop->getLoopsInPreorder(), loop);
      if (counts_in_reals(*loop)) unroll_loops(loop->getLoopsInPreorder());  // LLVM calculates the values.
    }
    std::optional<Directive> pipeline = function_directive(function, "PIPELINE");
    if (pipeline && asks_for_pipeline(*pipeline)) unroll_loops(loops.getLoopsInPreorder());
  }
}

void resolve_object_directives(Module& module, DirectiveTable& table, Diagnostics& diagnostics) {
  for (Function& function : module) {
    if (function.isDeclaration()) continue;
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    for (Marker& marker : markers_of(function)) {
      if (marker.directive.kind == "DEPENDENCE") mark_claim(marker, loops, table.objects.size());
      ObjectDirective made = object_directive(marker);
      std::string misuse = misuse_of(made.directive.kind, made.object, function);
      if (!misuse.empty())
        diagnostics.warn(made.location, "pragma '" + made.directive.kind + "' has no effect: '" +
                                            marker.variable_name + "' " + misuse);
      // Elements that Vitis puts into one word of a reshaped array stand in as many banks.
      if (made.directive.kind == "ARRAY_RESHAPE") made.directive.kind = "ARRAY_PARTITION";
      table.objects.push_back(made);
      marker.call->eraseFromParent();
    }
  }
}

std::vector<Directive> loop_directives(const Loop& loop, const std::string& kind) {
  MDNode* id = loop.getLoopID();
  std::vector<Directive> found;
  if (!id) return found;
  for (const MDOperand& operand : drop_begin(id->operands()))
    if (std::optional<Directive> directive = directive_of(operand); directive && directive->kind == kind)
      found.push_back(*directive);
  return found;
}

std::optional<Directive> loop_directive(const Loop& loop, const std::string& kind) {
  std::vector<Directive> found = loop_directives(loop, kind);
  if (found.empty()) return std::nullopt;
  return found.back();
}

MDNode* with_directive(MDNode* id, const Directive& directive, LLVMContext& context) {
  SmallVector<Metadata*, 8> parts = {nullptr};
  if (id)
    for (const MDOperand& operand : drop_begin(id->operands()))
      if (std::optional<Directive> other = directive_of(operand); !other || other->kind != directive.kind)
        parts.push_back(operand);
  parts.push_back(string_node(context, {kLoopTag, to_text(directive)}));
  MDNode* made = MDNode::getDistinct(context, parts);
  made->replaceOperandWith(0, made);
  return made;
}

std::optional<Directive> function_directive(const Function& function, const std::string& kind) {
  Attribute attribute = function.getFnAttribute("hls-" + StringRef(kind).lower());
  if (!attribute.isValid()) return std::nullopt;
  return parse_directive(attribute.getValueAsString().str());
}

}  // namespace hlsc
