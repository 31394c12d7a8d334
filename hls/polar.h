/// Polar histogram, triangle scores and contact points along Bresenham lines (ICVS paper, algorithm 1, eq.
/// 17-18).
///
/// One time-multiplexed engine walks all lines: while row v streams into a ring of columns, every line takes
/// its step in row v - 1, one line a clock. A step covers the run of columns that Bresenham's algorithm gives
/// the line in that row (run-slice form, LineSetup): steep lines one pixel, shallow ones several.
///
/// Per column the ring holds what a step needs, so that a run of any length costs two reads:
///   before  high bits in the columns left of this one (running count), so the high bits in columns [a, b]
///   are
///           before(b) + high(b) - before(a);
///   window  eq. (17) around the column, columns outside the image read 0. Paper rule: a_high over 3 columns
///   (l = 1).
///           Run rule: bit 1 is a_high >= 1, bit 0 a_low >= 1, over 7 columns (l = 3);
///   motion  how far the pixel has moved against the floor (displacement.h).
///
/// Definitions at the borders. a_r belongs to the first column of the run in walk order; where that lies
/// outside the image, a_r = 0. Only columns inside the image are counted. Rows at or below `height` do not
/// exist: a line that reaches there ends in the image's last row. A line that starts there has count 0. Lines
/// beyond width - LINE_SLACK are not walked (the host refuses such sets). With no lines there are no contacts
/// and one LineCount {0, 0, end}.
///
/// Rules (docs/architecture.md): a run starts at a row where `present` holds (paper: a_high > 0, run: a_low
/// >= 1) and ends at the first row that is more than the allowed gap (paper: 0) below its last present row,
/// or at the line's last row, then `clipped`. rows = last present row - first + 1. Paper: S_c counts up while
/// a_r does not grow, else 0; contact when S_c > 4, in the last present row. Run: contact when rows >=
/// max(min_rows, least height there), at least a third of the rows are high, at least STIRRING_ROWS present
/// rows stir or move (what lies flat on the floor does neither), none of the last STILL_ROWS present rows
/// moves and the last one rests: a foot does not move, what stands above it does. In the last present row, or
/// the first for contact_first lines (ignored by the paper rule). Clipped runs and contact_first lines need
/// not end still.
///
/// Cycles a frame: width * height + LINE_DELAY + line_count + depth, II = 1. Latency from the last pixel of
/// the deciding row to the contact: LINE_DELAY + line index + depth; from the decided pixel itself at most
/// width more. depth: ~12.
#ifndef FLOORLINE_HLS_POLAR_H
#define FLOORLINE_HLS_POLAR_H

#include "hls_stream.h"
#include "parameters.h"
#include "raster.h"

namespace floorline {
namespace polar_engine {

/// Columns between the start of a row and the step of line 0: the last REACH windows of the row before
/// complete in the first columns, and their writes need time to land before a line reads them.
const int LINE_DELAY = 5;
/// Columns of a row that no line may take: LINE_DELAY, and the depth of the pipeline, so that a line's state
/// is written back long before its next step and the last step reads its row before the row is overwritten.
const int LINE_SLACK = 16;
/// A triangle of the paper has S_c above this.
const int TRIANGLE_SCORE = 4;
/// l of the run rule.
const int REACH = 3;
const int TAPS = 2 * REACH + 1;
/// Present rows in which a foot does not move.
const int STILL_ROWS = 7;
/// Present rows of an obstacle that move, if only by half of what a foot may.
const int STIRRING_ROWS = 7;
typedef ap_uint<3> FewRows;  ///< A count of rows up to 7.

/// What the steps need of one column, see above.
struct Summary {
  Size before;
  ap_uint<1> high;
  ap_uint<2> window;
  Motion motion;
};

/// Where a line stands between two rows. Packs into 96 bits.
struct LineState {
  Coordinate column;  ///< First column of the coming run.
  Size error;
  ap_uint<1> carry;           ///< The coming run has slice + 1 pixels.
  Size count;                 ///< High pixels so far.
  ap_uint<2> present;         ///< Within a run: paper a_r of the row before, run rule 1. 0: no run.
  Size first_row;             ///< First present row of the run.
  Size last_row;              ///< Last present row of the run.
  Size score;                 ///< Paper: S_c. Run rule: high rows.
  Coordinate contact_column;  ///< u of the contact that the run would give.
  FewRows still_rows;         ///< Last present rows that did not move, up to STILL_ROWS.
  FewRows stirring_rows;      ///< Present rows that stirred or moved, up to STIRRING_ROWS.
  ap_uint<1> rests;           ///< The last present row does.
};

/// Columns that a line covers in one row, and its state for the next row (but for rule and count).
struct Step {
  Coordinate first;  ///< First column in walk order: `left`, or `right` of a leftward line.
  Coordinate left;
  Coordinate right;
  LineState next;
};

/// A pixel as the engine takes it in: bits 3:2 its motion, bits 1:0 the mask.
typedef ap_uint<4> Sample;

/// The last pixels of the stream; [REACH] is the centre of the window.
struct Taps {
  Sample pixel[TAPS];
};

inline void shift(Taps& taps, Sample pixel) {
#pragma HLS INLINE
SHIFT:
  for (int i = TAPS - 1; i > 0; --i) {
#pragma HLS UNROLL
    taps.pixel[i] = taps.pixel[i - 1];
  }
  taps.pixel[0] = pixel;
}

/// Mask of tap i when the newest pixel is in `column`. The first REACH columns complete the end of the row
/// before; taps that belong to the neighbouring row read 0.
inline Mask mask_at(const Taps& taps, int i, Size column) {
#pragma HLS INLINE
  const bool row_before = column < REACH;
  const bool same_row = i < REACH ? !row_before || column < i : row_before || column >= i;
  return same_row ? Mask(taps.pixel[i]) : Mask(0);
}

/// eq. (17) around the centre.
inline ap_uint<2> window_sum(const Taps& taps, Size column, ap_uint<1> run_rule) {
#pragma HLS INLINE
  Mask any = 0;
ANY:
  for (int i = 0; i < TAPS; ++i) {
#pragma HLS UNROLL
    any = any | mask_at(taps, i, column);
  }
  const Mask right = mask_at(taps, REACH - 1, column), left = mask_at(taps, REACH + 1, column);
  const ap_uint<2> sum = ap_uint<1>(right[1]) + ap_uint<1>(taps.pixel[REACH][1]) + ap_uint<1>(left[1]);
  return run_rule ? ap_uint<2>(any) : sum;
}

/// One step of the run-slice walk in `row`.
inline Step walk(const LineSetup& line, const LineState& state, Size row) {
#pragma HLS INLINE
  Step step;
  step.next = state;
  const bool starts = row == line.first_row;
  if (starts) {
    step.next.column = line.first_column;
    step.next.error = line.first_error;
    step.next.count = 0;
    step.next.present = 0;
  }
  Size run = line.slice == 0 ? Size(1) : Size(line.slice + state.carry);
  if (starts) run = line.first_run;
  if (row == line.last_row) run = line.last_run;

  step.first = step.next.column;
  step.left = line.leftward ? Coordinate(step.first - run + 1) : step.first;
  step.right = line.leftward ? step.first : Coordinate(step.first + run - 1);

  const ap_uint<13> error = step.next.error + line.remainder;
  const ap_uint<1> carry = error >= line.divisor;
  const Size advance = line.slice == 0 ? Size(carry) : run;
  step.next.error = carry ? Size(error - line.divisor) : Size(error);
  step.next.carry = carry;
  step.next.column = line.leftward ? Coordinate(step.first - advance) : Coordinate(step.first + advance);
  return step;
}

inline Size clamp_column(Coordinate column, Size width) {
#pragma HLS INLINE
  if (column < 0) return 0;
  return column < width ? Size(column) : Size(width - 1);
}

/// One more row, as long as the count has not reached `most`.
inline FewRows one_more(FewRows rows, int most) {
#pragma HLS INLINE
  return rows == most ? rows : FewRows(rows + 1);
}

/// Feeds a_r of `row` to the rule. True when a run ended here as a contact, which is then in `contact`.
inline bool apply_rule(const RuleParameters& rule, const LineSetup& line, Size row, bool line_ends,
                       Coordinate column, ap_uint<2> window, Motion motion, LineState& state,
                       Contact& contact) {
#pragma HLS INLINE
  const bool in_run = state.present != 0;
  const bool first_counts = rule.run_rule && line.contact_first;
  const ap_uint<2> present = rule.run_rule ? ap_uint<2>(window & 1) : window;
  if (present != 0) {
    const Size high_rows = (in_run ? state.score : Size(0)) + ap_uint<1>(window[1]);
    const Size triangle = window <= state.present ? Size(state.score + 1) : Size(0);
    state.score = rule.run_rule ? high_rows : triangle;
    const FewRows still_before = in_run ? state.still_rows : FewRows(0);
    const FewRows stirring_before = in_run ? state.stirring_rows : FewRows(0);
    state.still_rows = motion == MOVES ? FewRows(0) : one_more(still_before, STILL_ROWS);
    state.stirring_rows = motion == RESTS ? stirring_before : one_more(stirring_before, STIRRING_ROWS);
    state.rests = motion == RESTS || motion == UNKNOWN;
    if (!in_run) state.first_row = row;
    if (!in_run || !first_counts) state.contact_column = column;
    state.last_row = row;
  }
  const Size gap = row - state.last_row;
  const bool gap_ends = gap > (rule.run_rule ? rule.max_gap : Size(0));
  const bool ended = (in_run || present != 0) && (gap_ends || line_ends);
  if (ended) {
    state.present = 0;
  } else if (present != 0) {
    state.present = present;
  }

  const Size rows = state.last_row - state.first_row + 1;
  const Size contact_row = first_counts ? state.first_row : state.last_row;
  const ap_int<24> least_rows = ((contact_row - rule.horizon_row) * rule.height_ratio) >> 8;
  const bool tall = rows >= rule.min_rows && rows >= least_rows && 3 * state.score >= rows;
  const bool stands = state.stirring_rows == STIRRING_ROWS;
  const bool ends_still = state.still_rows == STILL_ROWS && state.rests;
  const bool still = ends_still || line.contact_first || !gap_ends;
  const bool triangle = state.score > TRIANGLE_SCORE;

  contact.u = state.contact_column;
  contact.v = contact_row;
  contact.rows = rule.run_rule ? rows : state.score;
  contact.clipped = !gap_ends;
  contact.end = 0;
  return ended && (rule.run_rule ? tall && stands && still : triangle);
}

}  // namespace polar_engine

/// Mask and motion (width * height pixels) -> contacts, in the order of their deciding rows, and one
/// LineCount a line at frame end. Widths of at least LINE_SLACK, up to MAX_WIDTH; lines: host memory of
/// MAX_LINES entries, read once a row.
template <int MAX_WIDTH, int MAX_HEIGHT, int MAX_LINES>
void polar(hls::stream<Mask>& mask, hls::stream<Motion>& motions, hls::stream<Contact>& contacts,
           hls::stream<LineCount>& counts, Size width, Size height, ap_uint<9> line_count,
           const RuleParameters& rule, const LineSetup lines[MAX_LINES]) {
  static_assert(MAX_LINES <= 256, "LineIndex holds 8 bits: at most 256 lines");
  using namespace polar_engine;
  // A row, and as much of the next one as streams in until the last line has taken its step. Column u of row
  // v lies at v * width + u, modulo the ring. Two copies, one for each end of a run.
  typedef ap_uint<BitWidth<MAX_WIDTH + MAX_LINES + LINE_SLACK - 1>::value> RingIndex;
  const int RING_COLUMNS = 1 << RingIndex::width;
  static Summary left_columns[RING_COLUMNS];
  static Summary right_columns[RING_COLUMNS];
  static LineState states[MAX_LINES];
#pragma HLS AGGREGATE variable = left_columns
#pragma HLS AGGREGATE variable = right_columns
#pragma HLS AGGREGATE variable = states
#pragma HLS AGGREGATE variable = lines

  const Size free_columns = width < LINE_SLACK ? Size(0) : Size(width - LINE_SLACK);
  const ap_uint<9> walked = line_count < free_columns ? line_count : ap_uint<9>(free_columns);
  const Size tail = LINE_DELAY + walked;
  const Size last_step = tail - 1;
  Taps taps = {};
  Size high_before = 0;
  RingIndex centre = -REACH;
  RingIndex row_start = -width;  // of the row before the one that comes in

  if (walked == 0) {
    const LineCount none = {0, 0, 1};
    counts.write(none);
  }

  // Row `height` holds no pixels, just the steps of the lines in the last row.
  bool steps_wait = true;
CYCLES:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside || steps_wait; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT + MAX_LINES
// True: a line reads its row LINE_DELAY or more steps after that was written and LINE_SLACK - LINE_DELAY or
// more before it is overwritten; its state was written one width (>= LINE_SLACK) before.
#pragma HLS DEPENDENCE variable = left_columns inter false
#pragma HLS DEPENDENCE variable = right_columns inter false
#pragma HLS DEPENDENCE variable = states inter false
    // The row that comes in.
    const bool streaming = at.inside;
    Sample pixel = 0;
    if (streaming) {
      const Mask bits = mask.read();
      pixel = (motions.read(), bits);
    }
    shift(taps, pixel);
    const Sample middle = taps.pixel[REACH];
    const Summary summary = {high_before, ap_uint<1>(middle[1]), window_sum(taps, at.u, rule.run_rule),
                             Motion(middle.range(3, 2))};
    left_columns[centre] = summary;
    right_columns[centre] = summary;
    centre = centre + 1;
    high_before = at.u == REACH - 1 ? Size(0) : Size(high_before + summary.high);

    // The row before, one line.
    const Size row = at.v - 1;
    if (at.v != 0 && at.u >= LINE_DELAY && at.u < tail) {
      const LineIndex index = at.u - LINE_DELAY;
      const LineSetup line = lines[index];
      const Step step = walk(line, states[index], row);
      LineState next = step.next;
      if (row >= line.first_row && row <= line.last_row) {
        const Summary left = left_columns[RingIndex(row_start + clamp_column(step.left, width))];
        const Summary right = right_columns[RingIndex(row_start + clamp_column(step.right, width))];
        const bool in_image = step.left < width && step.right >= 0;
        if (in_image) next.count += right.before + right.high - left.before;
        const Summary first = line.leftward ? right : left;
        const bool first_in_image = step.first >= 0 && step.first < width;
        const bool line_ends = row == line.last_row || !streaming;
        Contact contact;
        contact.line = index;
        if (apply_rule(rule, line, row, line_ends, step.first, first_in_image ? first.window : ap_uint<2>(0),
                       first.motion, next, contact)) {
          contacts.write(contact);
        }
        states[index] = next;
      }
      if (!streaming) {
        const LineCount count = {index, row < line.first_row ? Size(0) : next.count, index == walked - 1};
        counts.write(count);
      }
    }
    if (at.at_row_end()) row_start = row_start + width;
    if (!streaming && at.u == last_step) steps_wait = false;
  }

  const Contact end = {0, 0, 0, 0, 0, 1};
  contacts.write(end);
}

}  // namespace floorline

#endif
