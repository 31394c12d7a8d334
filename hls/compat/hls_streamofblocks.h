/// hls::stream_of_blocks has no stand-in: two processes of a DATAFLOW function share an array as two banks.
#error "hls::stream_of_blocks is not built; pass an array from process to process of a DATAFLOW function"
