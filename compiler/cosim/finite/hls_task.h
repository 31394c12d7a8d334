/// hls::task never ends, and csim --finite-fifos runs processes that do.
#error "csim --finite-fifos has no hls::task; use csim without it, or cosim, which has the declared depths too"
