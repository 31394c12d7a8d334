/// A Verilator class of rtl/floorline_top behind TopModel.
#ifndef FLOORLINE_TB_COSIM_VERILATED_TOP_H
#define FLOORLINE_TB_COSIM_VERILATED_TOP_H

#include <verilated.h>
#include <verilated_fst_c.h>

#include "tb/cosim/top.h"

namespace floorline::cosim {

template <std::size_t N>
PackedElement element(const VlWide<N>& bits) {
  PackedElement words = {};
  for (std::size_t i = 0; i < N; ++i) words[i] = bits[i];
  return words;
}

inline PackedElement element(IData bits) { return {bits}; }

template <typename Verilated>
class VerilatedTop : public TopModel {
 public:
  explicit VerilatedTop(std::uint64_t seed) {
    context_.traceEverOn(true);
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed) + 1);
    top_ = std::make_unique<Verilated>(&context_);
  }
  ~VerilatedTop() override {
    if (waves_) waves_->close();
    top_->final();
  }

  bool tick(Agents& agents, std::uint64_t cycle) override {
    drive(agents);
    top_->aclk = 0;
    top_->eval();
    if (waves_) waves_->dump(2 * cycle);
    if (watch_ != nullptr) watch_->see({cycle, ports()});
    const bool moved = sample(agents, cycle);
    top_->aclk = 1;
    top_->eval();
    if (waves_) waves_->dump(2 * cycle + 1);
    return moved;
  }

  void set_reset(bool on) override {
    if (on) top_->s_axis_video_tvalid = top_->s_axil_awvalid = top_->s_axil_wvalid = top_->s_axil_arvalid = 0;
    top_->aresetn = !on;
  }

  void tick_unseen() override {
    top_->aclk = 0;
    top_->eval();
    top_->aclk = 1;
    top_->eval();
  }

  bool interrupt() const override { return top_->irq; }

  void record(const std::filesystem::path& file) override {
    waves_ = std::make_unique<VerilatedFstC>();
    top_->trace(waves_.get(), 99);
    waves_->open(file.c_str());
  }

  void show(PortWatch& watch) override { watch_ = &watch; }

 protected:
  Verilated& verilated() { return *top_; }

 private:
  void drive(Agents& agents) {
    agents.video.drive();
    top_->s_axis_video_tvalid = agents.video.valid();
    if (agents.video.valid()) {
      top_->s_axis_video_tdata = agents.video.beat().data;
      top_->s_axis_video_tuser = agents.video.beat().start_of_frame;
      top_->s_axis_video_tlast = agents.video.beat().end_of_line;
    }
    agents.points.drive();
    agents.obstacles.drive();
    agents.counts.drive();
    top_->m_axis_points_tready = agents.points.ready();
    top_->m_axis_obstacles_tready = agents.obstacles.ready();
    top_->m_axis_counts_tready = agents.counts.ready();

    const AxiLiteRequest& request = agents.registers.drive();
    top_->s_axil_awaddr = top_->s_axil_araddr = request.address;
    top_->s_axil_awvalid = request.awvalid;
    top_->s_axil_wdata = request.data;
    top_->s_axil_wstrb = request.strobe;
    top_->s_axil_wvalid = request.wvalid;
    top_->s_axil_bready = request.bready;
    top_->s_axil_arvalid = request.arvalid;
    top_->s_axil_rready = request.rready;
  }

  bool sample(Agents& agents, std::uint64_t cycle) {
    // The reset is registered once inside, so outputs are bound to be low from its second cycle on.
    const bool in_reset = !top_->aresetn;
    const auto sink = [&](PacketSink& to, bool valid, const auto& data, bool user, bool last) {
      return (valid || to.waiting() || in_reset) &&
             to.sample(valid, {element(data), user, last}, in_reset, cycle);
    };
    const auto tap = [&](std::size_t of, bool passes, std::uint8_t data) {
      if (passes) agents.taps[of].push_back(data);
    };
    tap(0, top_->tap_difference_tvalid & top_->tap_difference_tready, top_->tap_difference_tdata);
    tap(1, top_->tap_motion_tvalid & top_->tap_motion_tready, top_->tap_motion_tdata);
    tap(2, top_->tap_blurred_tvalid & top_->tap_blurred_tready, top_->tap_blurred_tdata);
    tap(3, top_->tap_region_tvalid & top_->tap_region_tready, top_->tap_region_tdata);
    bool moved = agents.video.sample(top_->s_axis_video_tready);
    moved |= sink(agents.points, top_->m_axis_points_tvalid, top_->m_axis_points_tdata,
                  top_->m_axis_points_tuser, top_->m_axis_points_tlast);
    moved |= sink(agents.obstacles, top_->m_axis_obstacles_tvalid, top_->m_axis_obstacles_tdata,
                  top_->m_axis_obstacles_tuser, top_->m_axis_obstacles_tlast);
    moved |= sink(agents.counts, top_->m_axis_counts_tvalid, top_->m_axis_counts_tdata,
                  top_->m_axis_counts_tuser, top_->m_axis_counts_tlast);
    agents.registers.sample({.awready = static_cast<bool>(top_->s_axil_awready),
                             .wready = static_cast<bool>(top_->s_axil_wready),
                             .bvalid = static_cast<bool>(top_->s_axil_bvalid),
                             .arready = static_cast<bool>(top_->s_axil_arready),
                             .rvalid = static_cast<bool>(top_->s_axil_rvalid),
                             .bresp = top_->s_axil_bresp,
                             .rresp = top_->s_axil_rresp,
                             .rdata = top_->s_axil_rdata},
                            in_reset, cycle);
    return moved;
  }

  /// In the order of Port.
  decltype(PortCycle::ports) ports() const {
    const auto port = [](bool valid, bool ready, const auto& data) {
      return PortState{valid, ready, element(data)};
    };
    return {port(top_->s_axis_video_tvalid, top_->s_axis_video_tready, top_->s_axis_video_tdata),
            port(top_->m_axis_points_tvalid, top_->m_axis_points_tready, top_->m_axis_points_tdata),
            port(top_->m_axis_obstacles_tvalid, top_->m_axis_obstacles_tready, top_->m_axis_obstacles_tdata),
            port(top_->m_axis_counts_tvalid, top_->m_axis_counts_tready, top_->m_axis_counts_tdata),
            port(top_->tap_difference_tvalid, top_->tap_difference_tready, top_->tap_difference_tdata),
            port(top_->tap_motion_tvalid, top_->tap_motion_tready, top_->tap_motion_tdata),
            port(top_->tap_blurred_tvalid, top_->tap_blurred_tready, top_->tap_blurred_tdata),
            port(top_->tap_region_tvalid, top_->tap_region_tready, top_->tap_region_tdata)};
  }

  VerilatedContext context_;
  std::unique_ptr<Verilated> top_;
  std::unique_ptr<VerilatedFstC> waves_;
  PortWatch* watch_ = nullptr;
};

}  // namespace floorline::cosim

#endif
