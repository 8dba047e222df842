#pragma once

// Small files in the formats of strong-motion networks, made here: real records are not ours to ship. Each
// holds the same acceleration in its first component that can be chosen, 0, 2, -3, 1, 0, ... cm/s2 every 0.01
// s, and where a format has three components, twice and three times that in the others.

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

namespace tremolo::testing {

inline constexpr double network_step = 0.01; // s

/// cm/s2; the mean is zero.
inline const std::vector<double>& network_samples() {
  static const std::vector<double> samples = {0.0, 2.0, -3.0, 1.0, 0.0, -1.0, 2.0, -1.0, 0.0, 0.0, 1.0, -1.0};
  return samples;
}

struct NetworkText {
  const char* file;
  const char* format;
  std::string text;
  std::vector<std::string>
      components; ///< a part of each one's name; one that is empty where there is only one
};

/// Numbers in lines of `per_line`, each as `field` writes it, times a factor.
inline std::string in_fields(const std::vector<double>& values, std::size_t per_line,
                             const std::function<std::string(double)>& field, double factor = 1.0) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += field(factor * values[i]);
    if ((i + 1) % per_line == 0 || i + 1 == values.size())
      text += '\n';
  }
  return text;
}

inline std::function<std::string(double)> fixed(int width, int decimals) {
  return [=](double value) { return fmt::format("{:{}.{}f}", value, width, decimals); };
}

inline std::function<std::string(double)> whole(int width) {
  return [=](double value) { return fmt::format("{:{}d}", static_cast<long>(value), width); };
}

inline std::string knet_text() {
  std::vector<double> counts;
  for (const double sample : network_samples())
    counts.push_back(2.0 * sample + 10192.0);
  return "Origin Time       2011/06/30 23:45:00\nLat.              36.213\nStation Code      ABC001\n"
         "Record Time       2011/06/30 23:45:48\nSampling Freq(Hz) 100Hz\nDuration Time(s)  0.12\nDir.       "
         "   "
         "    E-W\n"
         "Scale Factor      2000(gal)/4000\nMax. Acc. (gal)   3.000\nLast Correction   2011/06/30 23:45:33\n"
         "Memo.             \n" +
         in_fields(counts, 8, whole(9));
}

inline std::string smc_text() {
  std::vector<double> integers(48, -32768.0);
  integers[12] = 90.0;
  integers[13] = 360.0;
  integers[15] = 1.0;
  integers[16] = static_cast<double>(network_samples().size());
  std::vector<double> reals(50, 1.7e38);
  reals[1] = 100.0;
  reals[29] = 2.0;
  reals[31] = -3.0;
  const auto real = [](double value) { return fmt::format("{:15.7E}", value); };
  const auto short_real = [](double value) {
    const std::string text = fmt::format("{:.4E}", value); // 1.5057E+00, one digit of the exponent
    return fmt::format("{:>10}", text.substr(0, text.size() - 2) + text.back());
  };
  return "2 CORRECTED ACCELEROGRAM\n*\nABC\n     1989  10  18    0004 SOME EVENT\nMoment Mag= 7.1\n"
         "station = SOME PLACE, component= 360\nepicentral dist = 89.0\ninst type=SMA-1\n*\n*\n*\n" +
         in_fields(integers, 8, whole(10)) + in_fields(reals, 5, real) + "| a comment\n" +
         in_fields(network_samples(), 8, short_real);
}

inline std::string cosmos_text() {
  const std::vector<double> integers(100, -999.0);
  std::vector<double> reals(100, -999.0);
  const auto count = static_cast<double>(network_samples().size());
  reals[61] = 1e3 * network_step;
  reals[62] = count * network_step;
  std::string text;
  for (int channel = 1; channel <= 3; ++channel) {
    reals[63] = -3.0 * channel;
    text += fmt::format("Corrected acceleration    (Format v01.20 with 13 text lines)\nSome place\n"
                        "Sta Cha:  {}: {} deg (Rcrdr Chan  {}) Location: ground\n"
                        "Record filtered below 0.30  Hz, and above 40.0 Hz\n"
                        " 100 Integer-header values follow on  10 lines, Format= (10I8)\n",
                        channel, 45 * channel, channel);
    text += in_fields(integers, 10, whole(8));
    text +=
        " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" + in_fields(reals, 6, fixed(13, 6));
    text += fmt::format(
        "   1 Comment line(s) follow, each starting with a \"|\":\n| units=mg of this line are not read\n"
        "   {} acceleration pts, approx 0.1 secs, units=cm/sec2(04),Format=(8F10.5)\n",
        count);
    text += in_fields(network_samples(), 8, fixed(10, 5), channel);
    text += fmt::format("/&  ----------  End of data for channel  {}  ----------\n", channel);
  }
  return text;
}

inline std::string csmip_text() {
  const auto count = network_samples().size();
  std::string text;
  for (int channel = 1; channel <= 3; ++channel) {
    text +=
        fmt::format("CORRECTED ACCELEROGRAM   36456-S4384-83123.01       CHAN  {0}:  {1} DEG     FROM\n"
                    "UNCORRECTED ACCELEROGRAM DATA              PROCESSED:  6/06/83\nCHAN  {0}:  {1} DEG\n"
                    "ACCELEROGRAM BANDPASS FILTERED WITH RAMPS AT  .050- .100 AND 23.00-25.00 CYC/SEC\n"
                    "  {2} POINTS OF INSTRUMENT- AND BASELINE-CORRECTED ACCEL, VELOC AND DISPL DATA\n"
                    "PEAK ACCELERATION =  {3:8.3f}    CM/SEC/SEC  AT   10.940   SEC.\n"
                    "PEAK   VELOCITY   =  {4:8.3f}      CM/SEC    AT   11.100   SEC.\n",
                    channel, 45 * channel, count, -3.0 * channel, -0.3 * channel);
    text += "    1    1 3251\n      .041      .630    65.000\n";
    text +=
        fmt::format(" {} POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC.  (UNITS: CM/SEC/SEC)\n", count);
    text += in_fields(network_samples(), 8, fixed(10, 3), channel);
    text +=
        fmt::format(" {} points of veloc data equally spaced at  .010 sec, in cm/sec.  (8f10.7)\n", count);
    text += in_fields(network_samples(), 8, fixed(10, 7), 0.1 * channel);
    text += fmt::format("/&  ----------  END OF DATA FOR CHANNEL  {}  ----------\n", channel);
  }
  return text;
}

inline std::string csmip_pairs_text() {
  const auto count = network_samples().size();
  std::string text;
  for (int channel = 1; channel <= 3; ++channel) {
    text += fmt::format("UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 07/27/2010\nSOME EVENT\n"
                        "CHAN  {}: {}       (STA CHN:  1)\nNO. OF POINTS =   {}  RECORD LENGTH = 0.120 SEC\n"
                        "UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  = {:6.4f} G, AT  23.180 SEC\n"
                        "RMS ACCEL OF COMPLETE RECORD = 0.006 G\n",
                        channel, std::vector{"EW", "NZ", "UP"}[static_cast<std::size_t>(channel) - 1], count,
                        -3.0 / 980.665 * channel);
    text += in_fields(std::vector<double>(100, 0.0), 16, whole(5));
    text += in_fields(std::vector<double>(50, 0.0), 8, fixed(10, 3));
    std::vector<double> pairs;
    for (std::size_t i = 0; i < count; ++i) {
      pairs.push_back(network_step * static_cast<double>(i));
      pairs.push_back(10.0 * channel * network_samples()[i] / 980.665);
    }
    text += in_fields(pairs, 10, fixed(7, 4));
    text += "/&  ----------  END OF DATA FOR CHANNEL ----------\n";
  }
  return text;
}

inline std::string bhrc_text() {
  const auto real = [](double value) { return fmt::format("{:13.6E}", value); };
  std::string reals;
  for (int line = 1; line <= 7; ++line)
    reals += real(line == 2 ? 100.0 : 0.0) + real(0.0) + real(0.0) + real(0.0) + real(0.0) + "  .00\n";
  std::string text;
  for (int channel = 1; channel <= 3; ++channel) {
    text += fmt::format("* VOL1DS FILE:  5522/01\n\nCOMP {}\nSome place\n"
                        "NO. OF POINTS =   {}      DURATION =  0.120\nUNITS ARE SECONDS AND G/10\n \n",
                        std::vector{"L1", "V2", "T3"}[static_cast<std::size_t>(channel) - 1],
                        network_samples().size());
    text += in_fields(std::vector<double>(88, 0.0), 14, whole(5)) + reals;
    text += in_fields(network_samples(), 10, real, 10.0 * channel / 980.665) + "/&\n";
  }
  return text;
}

inline std::string geonet_text() {
  const auto count = static_cast<double>(network_samples().size());
  std::vector<double> integers(40, 0.0);
  for (const std::size_t i : {33U, 34U, 35U})
    integers[i] = count;
  std::string text;
  for (int channel = 1; channel <= 3; ++channel) {
    text += fmt::format(
        "Corrected accelerogram 20161113_110256_ABCD_20 GNS Science\nSite ABCD      42 37 10S  173 03 13E\n"
        "Some place\nInstrument\nResolution: 18-bit\nAccelerogram\nSome event\n2016 November 13\nEpicentre\n"
        "Number of points  {}    Duration 0.12 sec\nInstrument corrected data at 0.010 sec intervals\n"
        "Band-pass filter transition bands are .10-.25 Hz and 24.50-25.50 Hz\n"
        "Component {}  Longitudinal Accelerometer Axis\n"
        "Acceleration:  peak {:8.1f} mm/s/s at  44.88 sec     rms    719.0 mm/s/s\n"
        "Velocity:      peak {:8.2f} mm/s   at  46.58 sec     rms    96.10 mm/s\n"
        "Displacement:  peak {:8.3f} mm     at  46.36 sec     rms   38.013 mm\n",
        count, std::vector{"N28W", "N62E", "Up"}[static_cast<std::size_t>(channel) - 1], -30.0 * channel,
        -3.0 * channel, -0.3 * channel);
    text += in_fields(integers, 10, whole(8)) + in_fields(std::vector<double>(60, 0.0), 10, fixed(8, 2));
    text += in_fields(network_samples(), 10, fixed(8, 1), 10.0 * channel);
    text += in_fields(network_samples(), 10, fixed(8, 2), channel);
    text += in_fields(network_samples(), 10, fixed(8, 3), 0.1 * channel);
  }
  return text;
}

inline std::string dyna_text() {
  return fmt::format("EVENT_NAME: SOMEWHERE\nEVENT_ID: AB-1\nEVENT_DATE_YYYYMMDD: "
                     "20160824\nEVENT_TIME_HHMMSS: 013632\n"
                     "STATION_NAME: Some place\nSAMPLING_INTERVAL_S: 0.010000\nNDATA: {}\nSTREAM: "
                     "HNE\nUNITS: cm/s^2\n"
                     "PGA_CM/S^2: -3.000000\nTIME_PGA_S: 0.02\nBASELINE_CORRECTION: BASELINE REMOVED\n"
                     "FILTER_TYPE: BUTTERWORTH\nLOW_CUT_FREQUENCY_HZ: 0.200\nHEADER_FORMAT: DYNA 1.2\n"
                     "DATA_TYPE: ACCELERATION\nUSER1: text: with colons\n",
                     network_samples().size()) +
         in_fields(network_samples(), 1, fixed(0, 6));
}

/// A line of three components, each a multiple of the first, for each sample.
inline std::string three_columns(const std::function<std::string(double)>& field, bool times = false) {
  std::string text;
  for (std::size_t i = 0; i < network_samples().size(); ++i) {
    if (times)
      text += field(network_step * static_cast<double>(i));
    for (int component = 1; component <= 3; ++component)
      text += field(component * network_samples()[i]);
    text += '\n';
  }
  return text;
}

inline std::string unam_text() {
  return fmt::format(
             "       INSTITUTO DE INGENIERIA, UNAM\nARCHIVO ESTANDAR DE ACELERACION:\n"
             "ORIENTACION C1-C6 (rumbo;orientacion)  : /V/N00E/N90E\n"
             "INTERVALO DE MUESTREO, C1-C6 (s)       : /0.01/0.01/0.01\n"
             "NUM. TOTAL DE MUESTRAS, C1-C6          : /{0}/{0}/{0}\n"
             "ACEL. MAX.(Gal), C1-C6                 : /-3.0000/-6.0000/-9.0000\n"
             "UNIDADES DE LOS DATOS                  : Gal (cm/s/s)\n"
             "FACTOR DE DECIMACION                   : 1\nFORMATO DATOS (FORTRAN,10 campos/dato) : 3F10.4\n"
             "---------+---------+\n   CANAL-1   CANAL-2   CANAL-3\n         V      N00E      "
             "N90E\n---------+---------+\n",
             network_samples().size()) +
         three_columns(fixed(10, 4));
}

inline std::string cwb_text() {
  return "#Earthquake Information\n#StationCode: ABC\n#SampleRate(Hz): 100\n#AmplitudeUnit:  gal. "
         "DCoffset(corr)\n"
         "#AmplitudeMAX. U:    2.000~   -3.000\n#AmplitudeMAX. N:    4.000~   -6.000\n#DataSequence: Time "
         "U(+); N(+); E(+)\n"
         "#Data: 4F10.3 \n" +
         three_columns(fixed(10, 3), true);
}

inline std::string nsmn_text() {
  return fmt::format("STRONG GROUND MOTION RECORDS OF TURKIYE\nPLACE                   : SOMEWHERE\n"
                     "NUMBER OF DATA          : {}\nSAMPLING INTERVAL (sec) : 0.01\n"
                     "RAW PGA VALUES (gal)    : (N-S) 3.000000 (E-W) 6.000000 (U-D) 9.000000\n"
                     "       N-S          E-W          U-D\n",
                     network_samples().size()) +
         three_columns(fixed(13, 6));
}

inline std::vector<NetworkText> network_texts() {
  return {{"x.EW1", "K-NET, KiK-net", knet_text(), {"E-W"}},
          {"x.smc", "SMC", smc_text(), {"360"}},
          {"x.V2c", "COSMOS", cosmos_text(), {"45 deg", "90 deg", "135 deg"}},
          {"x.V2", "CSMIP", csmip_text(), {"45 DEG", "90 DEG", "135 DEG"}},
          {"x.v1", "CSMIP volume 1", csmip_pairs_text(), {"EW", "NZ", "UP"}},
          {"x.V1", "BHRC volume 1", bhrc_text(), {"L1", "V2", "T3"}},
          {"x.V2A", "GeoNet V2A", geonet_text(), {"N28W", "N62E", "Up"}},
          {"x.ASC", "ESM, DYNA", dyna_text(), {"HNE"}},
          {"x.191", "UNAM", unam_text(), {"V", "N00E", "N90E"}},
          {"x.dat", "CWB", cwb_text(), {"U", "N", "E"}},
          {"x.txt", "NSMN", nsmn_text(), {"N-S", "E-W", "U-D"}}};
}

} // namespace tremolo::testing
