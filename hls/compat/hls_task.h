/// hls::task has no stand-in.
#error "hls::task is not built; call the functions in a DATAFLOW function with INTERFACE ap_ctrl_none port=return"
