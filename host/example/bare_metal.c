/* A host without an operating system: frame parameters once, then a homography for every frame. The core lies at CORE_ADDRESS. */
#include <stdint.h>

#include "rtl/floorline_registers.h"

#define CORE_ADDRESS 0x43c00000u
#define WORDS(first, last) (((last) - (first)) / 4 + 1)

enum {
  PARAMETER_WORDS = WORDS(FLOORLINE_WIDTH, FLOORLINE_RULE_MIN_LINES),
  HOMOGRAPHY_WORDS = WORDS(FLOORLINE_HOMOGRAPHY_XU, FLOORLINE_HOMOGRAPHY_Z1)
};

static volatile uint32_t *const core = (volatile uint32_t *)CORE_ADDRESS;

/* The words of docs/registers.md from WIDTH on, as host/driver.cpp packs them, and of the line table, four a line. */
extern const uint32_t parameters[PARAMETER_WORDS];
extern const uint32_t lines[];
extern const uint32_t line_count;
/* The homography of the coming frame, from odometry. */
void next_homography(uint32_t homography[HOMOGRAPHY_WORDS]);

static void write_words(uint32_t offset, const uint32_t *words, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) core[offset / 4 + i] = words[i];
}

/* Returns when another core answers; the results come as AXI4-Streams. */
void drive_core(void) {
  uint32_t homography[HOMOGRAPHY_WORDS];
  if (core[FLOORLINE_ID / 4] != FLOORLINE_ID_VALUE) return;
  write_words(FLOORLINE_WIDTH, parameters, PARAMETER_WORDS);
  write_words(FLOORLINE_LINES, lines, 4 * line_count);
  core[FLOORLINE_UPDATE / 4] = FLOORLINE_UPDATE_PARAMETERS_MASK | FLOORLINE_UPDATE_LINES_MASK;
  core[FLOORLINE_CONTROL / 4] = FLOORLINE_CONTROL_ENABLE_MASK;
  for (;;) {
    while (core[FLOORLINE_UPDATE / 4]) {
    } /* until the frame has started */
    next_homography(homography);
    write_words(FLOORLINE_HOMOGRAPHY_XU, homography, HOMOGRAPHY_WORDS);
    core[FLOORLINE_UPDATE / 4] = FLOORLINE_UPDATE_PARAMETERS_MASK;
  }
}
