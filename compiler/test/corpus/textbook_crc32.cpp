// Bitwise CRC of a byte array.
// top: textbook_crc32
unsigned textbook_crc32(const unsigned char data[16]) {
  unsigned crc = 0xFFFFFFFFu;
  for (int i = 0; i < 16; ++i) {
    crc ^= data[i];
    for (int b = 0; b < 8; ++b) crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320u : 0u);  // expect: loop II=1 depth=1
  }
  return ~crc;
}
