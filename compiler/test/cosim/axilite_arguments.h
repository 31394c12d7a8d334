#include "ap_int.h"

void axilite_arguments(const short in[10], ap_uint<37> wide, char flags[7], long long big[6], int* sum,
                       ap_int<12>& last);
