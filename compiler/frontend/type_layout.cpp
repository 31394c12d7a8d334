#include "frontend/type_layout.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/RecordLayout.h>
#include <clang/Basic/SourceManager.h>

#include "frontend/diagnostic.h"

namespace hlsc {
namespace {

class LeafCollector {
 public:
  LeafCollector(clang::ASTContext& context, TypeLayout& layout) : context_(context), layout_(layout) {}

  void collect(clang::QualType type, const std::string& name, uint64_t offset) {
    type = type.getCanonicalType();
    if (const clang::RecordType* record = type->getAs<clang::RecordType>())
      collect_record(record->getDecl(), name, offset);
    else if (const clang::ConstantArrayType* array = context_.getAsConstantArrayType(type))
      collect_array(array, name, offset);
    else
      collect_scalar(type, name, offset);
  }

 private:
  void collect_record(const clang::RecordDecl* record, const std::string& name, uint64_t offset) {
    if (record->isUnion()) refuse(record->getLocation(), "a union has no hardware layout; use a struct");
    const clang::ASTRecordLayout& layout = context_.getASTRecordLayout(record);
    if (const auto* cxx = llvm::dyn_cast<clang::CXXRecordDecl>(record)) {
      for (const clang::CXXBaseSpecifier& base : cxx->bases()) {
        const clang::CXXRecordDecl* base_record = base.getType()->getAsCXXRecordDecl();
        collect(base.getType(), name, offset + layout.getBaseClassOffset(base_record).getQuantity());
      }
    }
    bool lone = std::distance(record->field_begin(), record->field_end()) == 1;
    for (const clang::FieldDecl* field : record->fields()) {
      if (field->isBitField())
        refuse(field->getLocation(), "bit-fields have no hardware layout; use ap_uint<N> or ap_int<N>");
      uint64_t field_offset = offset + layout.getFieldOffset(field->getFieldIndex()) / 8;
      // The value inside ap_uint and its like is an implementation detail: it has no name of its own.
      bool wrapper = lone && !field->getType()->isRecordType() && field->getAccess() != clang::AS_public;
      std::string field_name = field->getNameAsString();
      if (wrapper || is_vendor_type(record)) field_name.clear();
      collect(field->getType(), joined(name, field_name), field_offset);
    }
  }

  static bool is_vendor_type(const clang::RecordDecl* record) {
    std::string name = record->getNameAsString();
    return name.rfind("ap_", 0) == 0 && name.rfind("ap_axi", 0) != 0;
  }

  void collect_array(const clang::ConstantArrayType* array, const std::string& name, uint64_t offset) {
    uint64_t stride = context_.getTypeSizeInChars(array->getElementType()).getQuantity();
    for (uint64_t i = 0; i < array->getSize().getZExtValue(); ++i)
      collect(array->getElementType(), name + "[" + std::to_string(i) + "]", offset + i * stride);
  }

  void collect_scalar(clang::QualType type, const std::string& name, uint64_t offset) {
    if (type->isFloatingType())
      refuse({}, "'" + type.getAsString() + "' has no operators in hardware yet; use ap_fixed<W, I>");
    if (!type->isIntegralOrEnumerationType())
      refuse({},
             "type '" + type.getAsString() +
                 "' cannot be a value in hardware; use integers, bool, ap_int, ap_fixed or structs of them");
    Leaf leaf;
    leaf.name = name;
    leaf.byte_offset = offset;
    leaf.bytes = context_.getTypeSizeInChars(type).getQuantity();
    if (const auto* bit_int = type->getAs<clang::BitIntType>())
      leaf.width = bit_int->getNumBits();
    else
      leaf.width = type->isBooleanType() ? 1 : context_.getTypeSize(type);
    leaf.is_signed = type->isSignedIntegerOrEnumerationType();
    layout_.leaves.push_back(leaf);
  }

  static std::string joined(const std::string& path, const std::string& field) {
    if (path.empty() || field.empty()) return path + field;
    return path + "." + field;
  }

  [[noreturn]] void refuse(clang::SourceLocation where, const std::string& sentence) {
    clang::PresumedLoc place = context_.getSourceManager().getPresumedLoc(where);
    if (place.isInvalid()) throw CompileError(sentence);
    throw CompileError({place.getFilename(), place.getLine(), place.getColumn()}, sentence);
  }

  clang::ASTContext& context_;
  TypeLayout& layout_;
};

}  // namespace

TypeLayout layout_of(clang::ASTContext& context, clang::QualType type) {
  TypeLayout layout;
  layout.type_name = type.getUnqualifiedType().getAsString();
  if (type->isIncompleteType())
    throw CompileError("type '" + layout.type_name + "' is declared but not defined; include its definition");
  layout.bytes = context.getTypeSizeInChars(type).getQuantity();
  LeafCollector(context, layout).collect(type.getUnqualifiedType(), "", 0);
  return layout;
}

}  // namespace hlsc
