// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Ten minutes of a line with thirty drives, of whose bytes one in a hundred is damaged: pairs that never were come only
// from frames that a CRC of 16 bits lets through.
#include <rtuwire/trace/line_listener.hpp>

#include <cmath>
#include <set>
#include <utility>

#include "support/catch.hpp"
#include "trace/listener/made_line.hpp"

using namespace listening;

namespace {

struct pair_counts {
    std::size_t right{0};
    std::size_t by_crc{0};     ///< a damaged frame is in it: its CRC was right
    std::size_t by_framing{0}; ///< of two frames that passed undamaged, but not together; or of pieces
    std::size_t damaged{0};
    std::size_t missed{0};
};

constexpr std::uint64_t minutes = 60'000'000;

made_line damaged_line(std::uint32_t seed)
{
    made_line line{seed};
    while (line.length() < 10 * minutes) {
        line.add_read();
    }
    line.damage_bytes(100);
    return line;
}

void count(made_line const& line, heard_list const& heard, pair_counts& into)
{
    std::set<std::pair<bytes, bytes>> whole;
    std::set<bytes> damaged;
    for (heard_entry const& each : line.whole_truth()) {
        if (each.role == rtuwire::frame_role::response) {
            whole.insert({each.request, each.frame});
        }
    }
    for (sent_frame const& each : line.all()) {
        if (each.is_damaged) {
            damaged.insert(each.frame);
        }
    }
    std::set<std::pair<bytes, bytes>> found;
    for (heard_entry const& each : heard.frames) {
        if (each.role != rtuwire::frame_role::response or each.request.empty()) {
            continue;
        }
        if (whole.contains({each.request, each.frame})) {
            found.insert({each.request, each.frame});
        } else {
            bool const is_crc = damaged.contains(each.request) or damaged.contains(each.frame);
            ++(is_crc ? into.by_crc : into.by_framing);
        }
    }
    into.right += found.size();
    into.missed += whole.size() - found.size();
    into.damaged += damaged.size();
}

/// So many or fewer, with a probability of 99 %, where `mean` are expected.
std::size_t poisson_99(double mean)
{
    double term = std::exp(-mean);
    double sum = term;
    std::size_t most = 0;
    while (sum < 0.99) {
        ++most;
        term *= mean / static_cast<double>(most);
        sum += term;
    }
    return most;
}

/// Of lines with these seeds, as `hear` hears them.
template <typename Hear> pair_counts pairs_of(std::uint32_t seeds, Hear hear)
{
    pair_counts seen;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        made_line const line = damaged_line(seed);
        count(line, hear(line), seen);
    }
    UNSCOPED_INFO(seen.right << " right, " << seen.by_crc << " by CRC, " << seen.by_framing << " by framing, "
                             << seen.missed << " missed, " << seen.damaged << " damaged frames");
    CHECK(seen.by_framing == 0);
    CHECK(seen.right > seeds * 700);
    return seen;
}

/// The same of as many as the 99 % are meant for: of few lines a single one more would be too many.
template <typename Hear> pair_counts pairs_of_twenty(Hear hear)
{
    pair_counts const seen = pairs_of(20, hear);
    CHECK(seen.by_crc <= poisson_99(static_cast<double>(seen.damaged) / 65'536.0));
    return seen;
}

heard_list hear_in_lumps_of_16(made_line const& line) { return hear_in_lumps(line, rtuwire::milliseconds(16)); }

} // namespace

TEST_CASE("of damaged lines, byte by byte, no pair comes from framing and none is missed")
{
    CHECK(pairs_of(2, hear_by_bytes).missed == 0);
}
TEST_CASE("of damaged lines behind an adapter no pair comes from framing") { pairs_of(2, hear_in_lumps_of_16); }

TEST_CASE("of 20 damaged lines, byte by byte, no pair comes from framing and none is missed", "[.long]")
{
    CHECK(pairs_of_twenty(hear_by_bytes).missed == 0);
}
TEST_CASE("of 20 damaged lines behind an adapter no pair comes from framing", "[.long]")
{
    pairs_of_twenty(hear_in_lumps_of_16);
}
