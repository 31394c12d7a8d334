/// Addresses as numbers.
#ifndef HLSC_MIDDLE_BYTE_OFFSET_H
#define HLSC_MIDDLE_BYTE_OFFSET_H

#include <llvm/Analysis/Utils/Local.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Operator.h>

namespace hlsc {

/// Code for the bytes, an i64, from `object` to `pointer`, which lies in it; null when the way is not known,
/// as through anything but GEPs.
inline llvm::Value* bytes_from(llvm::IRBuilder<>& builder, const llvm::DataLayout& layout,
                               const llvm::Value* object, llvm::Value* pointer) {
  if (pointer == object) return builder.getInt64(0);
  auto* gep = llvm::dyn_cast<llvm::GEPOperator>(pointer);
  llvm::Value* before = gep ? bytes_from(builder, layout, object, gep->getPointerOperand()) : nullptr;
  return before ? builder.CreateNSWAdd(before, llvm::emitGEPOffset(&builder, layout, gep)) : nullptr;
}

}  // namespace hlsc

#endif
