#include "tb/cosim/top.h"

#include <fmt/format.h>
#include <verilated.h>
#include <verilated_fst_c.h>

#include "Vfloorline_top.h"
#include "host/error.h"

namespace floorline::cosim {
namespace {

template <std::size_t N>
PackedElement element(const VlWide<N>& bits) {
  PackedElement words = {};
  for (std::size_t i = 0; i < N; ++i) words[i] = bits[i];
  return words;
}

PackedElement element(IData bits) { return {bits}; }

}  // namespace

struct Top::Model {
  explicit Model(std::uint64_t seed) {
    context.traceEverOn(true);
    context.randReset(2);
    context.randSeed(static_cast<int>(seed) + 1);
  }

  VerilatedContext context;
  Vfloorline_top top{&context};
  std::unique_ptr<VerilatedFstC> waves;
};

Top::Top(Stalls stalls, std::uint64_t seed)
    : model_(std::make_unique<Model>(seed)),
      video_(stalls, 8 * seed),
      points_("m_axis_points", stalls, 8 * seed + 1),
      obstacles_("m_axis_obstacles", stalls, 8 * seed + 2),
      counts_("m_axis_counts", stalls, 8 * seed + 3),
      registers_(stalls, 8 * seed + 4) {
  reset();
}

Top::~Top() {
  if (model_->waves) model_->waves->close();
  model_->top.final();
}

void Top::drive() {
  Vfloorline_top& top = model_->top;
  video_.drive();
  top.s_axis_video_tvalid = video_.valid();
  if (video_.valid()) {
    top.s_axis_video_tdata = video_.beat().data;
    top.s_axis_video_tuser = video_.beat().start_of_frame;
    top.s_axis_video_tlast = video_.beat().end_of_line;
  }
  points_.drive();
  obstacles_.drive();
  counts_.drive();
  top.m_axis_points_tready = points_.ready();
  top.m_axis_obstacles_tready = obstacles_.ready();
  top.m_axis_counts_tready = counts_.ready();

  const AxiLiteRequest& request = registers_.drive();
  top.s_axil_awaddr = top.s_axil_araddr = request.address;
  top.s_axil_awvalid = request.awvalid;
  top.s_axil_wdata = request.data;
  top.s_axil_wstrb = request.strobe;
  top.s_axil_wvalid = request.wvalid;
  top.s_axil_bready = request.bready;
  top.s_axil_arvalid = request.arvalid;
  top.s_axil_rready = request.rready;
}

void Top::sample() {
  const Vfloorline_top& top = model_->top;
  // The reset is registered once inside, so outputs are bound to be low from its second cycle on.
  const bool in_reset = !top.aresetn;
  const auto sink = [&](PacketSink& to, bool valid, const auto& data, bool user, bool last) {
    return to.sample(valid, {element(data), user, last}, in_reset, cycle_);
  };
  bool moved = video_.sample(top.s_axis_video_tready);
  moved |= sink(points_, top.m_axis_points_tvalid, top.m_axis_points_tdata, top.m_axis_points_tuser,
                top.m_axis_points_tlast);
  moved |= sink(obstacles_, top.m_axis_obstacles_tvalid, top.m_axis_obstacles_tdata,
                top.m_axis_obstacles_tuser, top.m_axis_obstacles_tlast);
  moved |= sink(counts_, top.m_axis_counts_tvalid, top.m_axis_counts_tdata, top.m_axis_counts_tuser,
                top.m_axis_counts_tlast);
  if (moved) last_move_ = cycle_;
  registers_.sample({.awready = static_cast<bool>(top.s_axil_awready),
                     .wready = static_cast<bool>(top.s_axil_wready),
                     .bvalid = static_cast<bool>(top.s_axil_bvalid),
                     .arready = static_cast<bool>(top.s_axil_arready),
                     .rvalid = static_cast<bool>(top.s_axil_rvalid),
                     .bresp = top.s_axil_bresp,
                     .rresp = top.s_axil_rresp,
                     .rdata = top.s_axil_rdata},
                    in_reset, cycle_);
}

void Top::tick() {
  Vfloorline_top& top = model_->top;
  drive();
  top.aclk = 0;
  top.eval();
  if (model_->waves) model_->waves->dump(2 * cycle_);
  sample();
  top.aclk = 1;
  top.eval();
  if (model_->waves) model_->waves->dump(2 * cycle_ + 1);
  ++cycle_;
}

void Top::run_until(const std::function<bool()>& done) {
  last_move_ = cycle_;
  while (!done()) {
    tick();
    if (cycle_ - last_move_ > kIdleLimit) {
      throw Hang(
          fmt::format("Nothing moved on any stream for {} cycles, up to cycle {}.", kIdleLimit, cycle_));
    }
  }
}

void Top::reset(int cycles) {
  Vfloorline_top& top = model_->top;
  const auto edge = [&] {
    top.aclk = 0;
    top.eval();
    top.aclk = 1;
    top.eval();
    ++cycle_;
  };
  video_.reset();
  top.s_axis_video_tvalid = top.s_axil_awvalid = top.s_axil_wvalid = top.s_axil_arvalid = 0;
  top.aresetn = 0;
  edge();
  edge();  // Registers of the core fall one cycle after the reset's own.
  for (int i = 0; i < cycles; ++i) tick();
  for (PacketSink* sink : {&points_, &obstacles_, &counts_}) sink->reset();
  top.aresetn = 1;
}

bool Top::interrupt() const { return model_->top.irq; }

void Top::finish_access() {
  const std::uint64_t start = cycle_;
  while (registers_.busy()) {
    tick();
    if (cycle_ - start > kIdleLimit) {
      throw Hang(
          fmt::format("A register access of cycle {} was not answered in {} cycles.", start, kIdleLimit));
    }
  }
}

std::uint32_t Top::try_read(std::uint32_t offset) {
  registers_.begin_read(offset);
  finish_access();
  return registers_.response();
}

std::uint32_t Top::try_write(std::uint32_t offset, std::uint32_t value, std::uint32_t strobe) {
  registers_.begin_write(offset, value, strobe);
  finish_access();
  return registers_.response();
}

std::uint32_t Top::read32(std::uint32_t offset) {
  if (try_read(offset) != 0) throw Error(fmt::format("The core refuses a read of register {:#x}.", offset));
  return registers_.data();
}

void Top::write32(std::uint32_t offset, std::uint32_t value) {
  if (try_write(offset, value, 0xf) != 0)
    throw Error(fmt::format("The core refuses a write of register {:#x}.", offset));
}

void Top::record(const std::filesystem::path& file) {
  model_->waves = std::make_unique<VerilatedFstC>();
  model_->top.trace(model_->waves.get(), 99);
  model_->waves->open(file.c_str());
}

}  // namespace floorline::cosim
