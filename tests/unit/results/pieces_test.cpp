// Frames and checkpoints whose values come in pieces are those whose values were all there.

#include "results/checkpoint_file.hpp"
#include "sample_run.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <numeric>
#include <span>
#include <variant>
#include <vector>

using namespace tremolo::results;
using namespace sample_run;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

/// More than two chunks of a file, 65,536 rows each; and fewer than a chunk is worth.
constexpr std::array<std::size_t, 2> sizes{150'001, 70};

/// Passes values to `take` in pieces of 1, 2, 4, ... points.
template <class Number, class Take>
void give_in_pieces(const std::vector<Number>& values, std::size_t components, const Take& take) {
  std::size_t points = 1;
  for (std::size_t first = 0; first < values.size(); points *= 2) {
    const std::size_t count = std::min(points * components, values.size() - first);
    take(std::span(values).subspan(first, count));
    first += count;
  }
}

/// A field of the first frame.
template <class Number>
std::vector<Number> numbers_in_pieces(const RunReader& run, const char* name) {
  std::vector<Number> numbers;
  run.frame_field_in_pieces(0, name, [&](const FieldValues& piece) {
    const auto values = std::get<std::span<const Number>>(piece);
    numbers.insert(numbers.end(), values.begin(), values.end());
  });
  return numbers;
}

/// Values of a frame of particles.
struct Cloud {
  explicit Cloud(std::size_t size)
      : particles(size), stress(filled(1, 1, 4 * size)), position(filled(1, 2, 2 * size)), soil(size) {
    std::iota(soil.begin(), soil.end(), -3);
  }

  std::vector<Field> fields() const {
    return {{"stress", "Pa", 4, stress}, {"position", "m", 2, position}, {"soil", "1", 1, soil}};
  }
  std::vector<StreamedField> streamed() const {
    return {{"stress", "Pa", 4, false, [this](const auto& take) { give_in_pieces(stress, 4, take); }},
            {"position", "m", 2, false, [this](const auto& take) { give_in_pieces(position, 2, take); }},
            {"soil", "1", 1, true, [this](const auto& take) { give_in_pieces(soil, 1, take); }}};
  }

  std::size_t particles;
  std::vector<double> stress, position;
  std::vector<std::int32_t> soil;
};

TEST(Pieces, MakeTheFrameOfAllAtOnce) {
  const Folder folder;
  for (const std::size_t size : sizes) {
    SCOPED_TRACE(size);
    const Cloud cloud(size);
    RunWriter at_once(folder / "whole.h5", description);
    RunWriter in_pieces(folder / "pieces.h5", description);
    at_once.write_frame(0.5, cloud.fields());
    in_pieces.write_frame(0.5, size, cloud.streamed());
    EXPECT_EQ(in_pieces.checksums(), at_once.checksums());
    const std::array field_list{checksum_of_fields("/frames/0000", 0.5, cloud.fields())};
    EXPECT_THAT(in_pieces.checksums(), testing::ElementsAreArray(field_list));
    at_once.finish();
    in_pieces.finish();
    require_undamaged(folder / "pieces.h5", field_list);
    EXPECT_EQ(std::filesystem::file_size(folder / "pieces.h5"),
              std::filesystem::file_size(folder / "whole.h5"));
    const RunReader run(folder / "pieces.h5");
    EXPECT_EQ(run.frame_field(0, "stress").values, cloud.stress);
    EXPECT_EQ(run.frame_field(0, "position").values, cloud.position);
    EXPECT_EQ(run.frame_field(0, "position").unit, "m");
    EXPECT_TRUE(run.frame_field(0, "soil").integers);
    EXPECT_EQ(run.frame_field(0, "soil").values, std::vector<double>(cloud.soil.begin(), cloud.soil.end()));
    EXPECT_EQ(numbers_in_pieces<double>(run, "stress"), cloud.stress);
    EXPECT_EQ(numbers_in_pieces<std::int32_t>(run, "soil"), cloud.soil);
    const FieldShape shape = run.frame_field_shape(0, "position");
    EXPECT_EQ(shape.particles, size);
    EXPECT_EQ(shape.components, 2u);
    EXPECT_EQ(shape.unit, "m");
    EXPECT_FALSE(shape.integers);
  }
}

TEST(Pieces, ThatDoNotMakeAFrameAreRefused) {
  const Folder folder;
  for (const std::size_t size : sizes) {
    SCOPED_TRACE(size);
    const Cloud cloud(size);
    const Cloud more(size + 1);
    RunWriter run(folder / "run.h5", description);
    const auto write = [&](std::size_t particles, std::vector<StreamedField> fields) {
      return [&run, particles, fields] { run.write_frame(0.5, particles, fields); };
    };
    EXPECT_THAT(write(size + 1, cloud.streamed()),
                ThrowsMessage<std::invalid_argument>(HasSubstr(
                    std::to_string(2 * size) + " values where it needs " + std::to_string(2 * size + 2))));
    EXPECT_THAT(write(size, more.streamed()),
                ThrowsMessage<std::invalid_argument>(HasSubstr("position has")));
    std::vector<StreamedField> mixed = cloud.streamed();
    mixed.front().integers = true;
    EXPECT_THAT(write(size, mixed), ThrowsMessage<std::invalid_argument>(HasSubstr("stress mixes")));
    mixed = cloud.streamed();
    mixed.front().components = 3;
    EXPECT_THROW(write(size, mixed)(), std::invalid_argument);
    EXPECT_THAT(write(size, {mixed.back()}),
                ThrowsMessage<std::invalid_argument>(HasSubstr("needs the field position")));
    EXPECT_EQ(run.frame_count(), 0U);
    write(size, cloud.streamed())();
    run.finish();
    EXPECT_EQ(RunReader(folder / "run.h5").frame_times().size(), 1U) << "refusals leave the run as it was";
  }
}

TEST(Pieces, MakeTheArrayOfACheckpoint) {
  const Folder folder;
  const CheckpointIdentity identity{"domain", "0123abcd", 420};
  for (const std::size_t size : {sizes[0], sizes[1], std::size_t{0}}) {
    SCOPED_TRACE(size);
    const std::vector<double> numbers = filled(3, 1, size);
    std::vector<std::uint64_t> integers(size);
    std::iota(integers.begin(), integers.end(), ~std::uint64_t{0} - size);
    for (const char* const name : {"whole.h5", "pieces.h5"}) {
      CheckpointWriter writer(folder / name, identity);
      if (name[0] == 'w') {
        writer.write("numbers", numbers);
        writer.write("integers", integers);
      } else {
        writer.write_numbers("numbers", size, [&](const auto& take) { give_in_pieces(numbers, 1, take); });
        writer.write_integers("integers", size, [&](const auto& take) { give_in_pieces(integers, 1, take); });
      }
      writer.close();
    }
    EXPECT_EQ(std::filesystem::file_size(folder / "pieces.h5"),
              std::filesystem::file_size(folder / "whole.h5"));
    const CheckpointReader reader(folder / "pieces.h5", identity);
    EXPECT_EQ(reader.numbers("numbers"), numbers);
    EXPECT_EQ(reader.integers("integers"), integers);
  }
}

TEST(Pieces, ThatDoNotMakeAnArrayAreRefused) {
  const Folder folder;
  CheckpointWriter writer(folder / "domain.h5", {"domain", "0123abcd", 420});
  const std::vector<double> three(3, 1.0);
  const auto give = [&](const auto& take) { take(std::span(three)); };
  EXPECT_THAT([&] { writer.write_numbers("few", 4, give); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("few has 3 values where it needs 4")));
  EXPECT_THAT([&] { writer.write_numbers("many", 2, give); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("many has 2 values")));
}

} // namespace
