/// AXI4-Lite master with a monitor of the core's side: one write or read at a time, its channels in random
/// order.
#ifndef FLOORLINE_TB_COSIM_AXI_LITE_H
#define FLOORLINE_TB_COSIM_AXI_LITE_H

#include <cstdint>
#include <string>

#include "tb/cosim/axi_stream.h"
#include "tb/cosim/stalls.h"

namespace floorline::cosim {

/// The master's outputs.
struct AxiLiteRequest {
  bool awvalid = false, wvalid = false, bready = false, arvalid = false, rready = false;
  std::uint32_t address = 0, data = 0, strobe = 0xf;
};

/// The core's outputs.
struct AxiLiteResponse {
  bool awready, wready, bvalid, arready, rvalid;
  std::uint32_t bresp, rresp, rdata;
};

class AxiLiteMaster {
 public:
  AxiLiteMaster(Stalls level, std::uint64_t seed) : stalls_(level, seed) {}

  void begin_write(std::uint32_t address, std::uint32_t data, std::uint32_t strobe) {
    request_ = {.address = address, .data = data, .strobe = strobe};
    address_due_ = data_due_ = answer_due_ = true;
    reading_ = false;
  }
  void begin_read(std::uint32_t address) {
    request_ = {.address = address};
    address_due_ = answer_due_ = true;
    data_due_ = false;
    reading_ = true;
  }
  bool busy() const { return answer_due_; }
  /// Of the last read, and of the last write or read: 0 OKAY, 2 SLVERR.
  std::uint32_t data() const { return data_; }
  std::uint32_t response() const { return response_; }

  const AxiLiteRequest& drive() {
    if (!answer_due_) return request_;
    raise(reading_ ? request_.arvalid : request_.awvalid, address_due_);
    raise(request_.wvalid, data_due_);
    (reading_ ? request_.rready : request_.bready) = !stalls_.stall();
    return request_;
  }

  /// The core's side at the clock edge. Throws ProtocolError.
  void sample(const AxiLiteResponse& core, bool in_reset, std::uint64_t cycle) {
    if (in_reset) {
      if (core.bvalid || core.rvalid) fail("BVALID or RVALID is high in reset", cycle);
      abandon();
      return;
    }
    if (core.bvalid && (reading_ || address_due_ || data_due_ || !answer_due_))
      fail("BVALID without a write", cycle);
    if (core.rvalid && (!reading_ || address_due_ || !answer_due_)) fail("RVALID without a read", cycle);
    const bool valid = reading_ ? core.rvalid : core.bvalid;
    if (waiting_ && !valid) fail("the answer's VALID fell before READY", cycle);
    if (waiting_ &&
        (core.bresp != held_.bresp || core.rresp != held_.rresp || (reading_ && core.rdata != held_.rdata))) {
      fail("the answer changed before READY", cycle);
    }
    const bool ready = reading_ ? request_.rready : request_.bready;
    take(request_.awvalid, core.awready, address_due_);
    take(request_.arvalid, core.arready, address_due_);
    take(request_.wvalid, core.wready, data_due_);
    waiting_ = valid && !ready;
    held_ = core;
    if (!valid || !ready) return;
    response_ = reading_ ? core.rresp : core.bresp;
    data_ = core.rdata;
    request_.rready = request_.bready = answer_due_ = false;
  }

 private:
  void raise(bool& valid, bool due) {
    const bool stalled = stalls_.stall();
    if (due && !valid) valid = !stalled;
  }
  static void take(bool& valid, bool ready, bool& due) {
    if (!valid || !ready) return;
    valid = due = false;
  }
  void abandon() {
    request_ = {};
    address_due_ = data_due_ = answer_due_ = waiting_ = false;
  }
  [[noreturn]] static void fail(const char* what, std::uint64_t cycle) {
    throw ProtocolError(std::string("s_axil: ") + what + ", cycle " + std::to_string(cycle) + ".");
  }

  StallPattern stalls_;
  AxiLiteRequest request_;
  bool reading_ = false;
  bool address_due_ = false, data_due_ = false;  ///< Not taken yet.
  bool answer_due_ = false;
  bool waiting_ = false;
  AxiLiteResponse held_ = {};
  std::uint32_t data_ = 0, response_ = 0;
};

}  // namespace floorline::cosim

#endif
