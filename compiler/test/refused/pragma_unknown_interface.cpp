int pragma_unknown_interface(int x) {
#pragma HLS INTERFACE teleport port=x
  return x + 1;
}
// error: 2:9: INTERFACE mode 'teleport' does not exist; use one of ap_ctrl_chain, ap_ctrl_hs, ap_ctrl_none, ap_fifo, ap_memory, ap_none, ap_stable, ap_vld, axis, bram, s_axilite
