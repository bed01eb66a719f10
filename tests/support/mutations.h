#ifndef DPCONTACT_TESTS_SUPPORT_MUTATIONS_H
#define DPCONTACT_TESTS_SUPPORT_MUTATIONS_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <random>
#include <string>
#include <vector>

/// Files that somebody or something has altered, drawn from whole ones by a fixed seed.
namespace dpcontact::testing_mutations
{
  /// What stands where a number stood.
  inline const std::vector<std::string> extreme_numbers = {
    "0",      "-0",   "-1",  "1",     "1e308",      "-1e308",     "1e-320",
    "1e999",  "nan",  "inf", "-inf",  "2147483648", "4294967296", "9223372036854775808",
    "1e",     "0x10", "",    "\"1\"", "null",       "1e15",       "18446744073709551616",
    "-2e999", "1,1",  "[]",  "{}",    "true",       "0.5",        "18446744073709551615"};

  /// What is put somewhere.
  inline const std::vector<std::string> awkward_texts = {std::string(1, '\0'),
                                                         "\xff",
                                                         "\xc3",
                                                         "\"",
                                                         "\\",
                                                         ",",
                                                         "#",
                                                         "\n",
                                                         "\r\n",
                                                         ":",
                                                         ";",
                                                         "'",
                                                         "{",
                                                         "}",
                                                         "[",
                                                         "]",
                                                         "=",
                                                         "set ",
                                                         "include ",
                                                         "subsection ",
                                                         "end",
                                                         "%s%n",
                                                         "../",
                                                         " "};

  inline const std::vector<std::string> openings =
    {"[", "{", "{\"a\":", "[[", "(", "\"", "[{\"\":"};

  /// The largest file that is made of a small one.
  constexpr std::size_t most_bytes = std::size_t(1) << 20;

  class Mutator
  {
  public:
    Mutator(const std::uint64_t seed, const bool is_text)
      : generator(seed)
      , n_kinds(is_text ? 12 : 6)
    {}

    std::size_t below(const std::size_t limit)
    {
      return limit == 0 ? 0 : static_cast<std::size_t>(generator() % limit);
    }

    /// One to four alterations.
    std::string operator()(std::string text)
    {
      for (std::size_t left = 1 + below(4); left > 0; --left)
        alter(text);
      if (text.size() > most_bytes)
        text.resize(most_bytes);
      return text;
    }

  private:
    void alter(std::string &text)
    {
      const std::size_t at     = below(text.size() + 1);
      const std::size_t length = std::min(1 + below(small() ? 8 : 2000), text.size() - at);
      switch (below(n_kinds))
        {
          case 0:
            flip(text);
            break;
          case 1:
            for (std::size_t i = at; i < at + length; ++i)
              text[i] = any_byte();
            break;
          case 2:
            text.insert(at, text.substr(below(text.size()), length));
            break;
          case 3:
            small() ? text.resize(at) : static_cast<void>(text.erase(at, length));
            break;
          case 4:
            text.insert(at, std::string(length, any_byte()));
            break;
          case 5:
            overwrite_count(text);
            break;
          case 6:
          case 7:
            replace_number(text, at);
            break;
          case 8:
            text.insert(at, one_of(awkward_texts));
            break;
          case 9:
            nest(text, at);
            break;
          default:
            move_lines(text);
        }
    }

    bool small() { return below(4) != 0; }

    char any_byte() { return static_cast<char>(generator() & 0xff); }

    const std::string &one_of(const std::vector<std::string> &list)
    {
      return list[below(list.size())];
    }

    void flip(std::string &text)
    {
      for (std::size_t left = text.empty() ? 0 : 1 + below(8); left > 0; --left)
        {
          char &byte = text[below(text.size())];
          byte       = static_cast<char>(byte ^ (1 << below(8)));
        }
    }

    /// A binary number, where binary files keep sizes and addresses.
    void overwrite_count(std::string &text)
    {
      const std::uint64_t values[] = {
        0, 1, ~std::uint64_t(0), std::uint64_t(1) << below(64), generator()};
      const std::uint64_t value = values[below(std::size(values))];
      const std::size_t   size  = std::size_t(1) << below(4);
      if (text.size() >= size)
        std::memcpy(&text[below(text.size() - size + 1)], &value, size);
    }

    void replace_number(std::string &text, const std::size_t at)
    {
      const char *const digits = "0123456789";
      std::size_t       begin  = text.find_first_of(digits, at);
      if (begin == std::string::npos)
        begin = text.find_first_of(digits);
      if (begin == std::string::npos)
        return;
      const std::size_t end =
        std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size());
      text.replace(begin, end - begin, one_of(extreme_numbers));
    }

    /// Brackets within brackets, with and without their ends; and long repetitions.
    void nest(std::string &text, const std::size_t at)
    {
      const std::string &opening = one_of(openings);
      const std::size_t  depth   = std::size_t(1) << below(18);
      std::string        added;
      for (std::size_t i = 0; i < depth && added.size() < most_bytes; ++i)
        added += opening;
      if (below(2) == 0)
        added += std::string(depth, opening.front() == '{' ? '}' : ']');
      text.insert(at, added);
    }

    /// Lines twice, away, or elsewhere.
    void move_lines(std::string &text)
    {
      std::vector<std::size_t> starts = {0};
      for (std::size_t i = 0; i + 1 < text.size(); ++i)
        if (text[i] == '\n')
          starts.push_back(i + 1);
      const std::size_t first = below(starts.size());
      const std::size_t last  = std::min(first + 1 + below(small() ? 1 : 20), starts.size());
      const std::size_t begin = starts[first],
                        end   = last < starts.size() ? starts[last] : text.size();
      const std::string lines = text.substr(begin, end - begin);
      const std::size_t to    = starts[below(starts.size())];
      const std::size_t kind  = below(3);
      if (kind == 0)
        {
          text.erase(begin, end - begin);
          return;
        }
      if (kind == 2)
        text.erase(begin, end - begin);
      text.insert(std::min(to, text.size()), lines);
    }

    std::mt19937_64 generator;
    std::size_t     n_kinds;
  };
} // namespace dpcontact::testing_mutations

#endif
