#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <utility>

#include "scene/text_input.h"

namespace ping_pong
{
namespace
{
constexpr std::size_t kNameWidth = 34;  ///< of the help's first column
const std::string kHelp = "--help";

/// Options without the shorter spellings that they also have.
class HelpFormatter : public CLI::Formatter
{
public:
  HelpFormatter() { column_width(kNameWidth); }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
  {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;)
      text.erase(at, 1);  // one empty line is enough
    if (text.size() > 1 && text.compare(text.size() - 2, 2, "\n\n") == 0) text.pop_back();
    return text;
  }
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override
  {
    if (is_positional) return option->get_name(true, false);
    const std::string name = "--" + option->get_lnames().front();
    return option->get_snames().empty() ? name : "-" + option->get_snames().front() + "," + name;
  }
};

bool isPositional(const Option& option)
{
  return option.name.rfind("--", 0) != 0;
}

std::vector<std::string> namesOf(const CommandLine& line)
{
  std::vector<std::string> names = {kHelp};
  for (const OptionGroup& group : line.groups)
    for (const Option& option : group.options)
      if (!isPositional(option)) names.push_back(option.name);
  return names;
}

/// "--rate,--rat,--ra,--r": the name and every beginning that it shares with no other one, as getopt_long takes them.
std::string spellings(const std::string& name, const std::vector<std::string>& names)
{
  std::string all = name;
  for (std::size_t size = name.size() - 1; size > 2; --size)
  {
    const std::string beginning = name.substr(0, size);
    const auto begins = [&](const std::string& other) { return other.rfind(beginning, 0) == 0; };
    if (std::count_if(names.begin(), names.end(), begins) > 1) break;
    all += "," + beginning;
  }
  return all;
}

void give(const Option& option, const std::string& text)
{
  try
  {
    option.value.take(text);
  }
  catch (const Unexpected& unexpected)
  {
    refuse(option.name, text.empty() ? "nothing" : text, unexpected.expected);
  }
}

CLI::Option* addFlag(CLI::App& app, const Option& option, const std::string& spelled)
{
  return app.add_flag_callback(
      spelled, [&option] { give(option, ""); }, option.help);
}

CLI::Option* addValue(CLI::App& app, const Option& option, const std::string& spelled)
{
  const CLI::callback_t take = [&option](const CLI::results_t& words)
  {
    give(option, words.front());
    return true;
  };
  CLI::Option* const added = app.add_option(spelled, take, option.help);
  added->type_name(option.value_name)
      ->default_str(option.required ? "" : option.value.standard)
      ->required(option.required);
  return added->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// @param line  outlives the app
void add(CLI::App& app, const CommandLine& line)
{
  const std::vector<std::string> names = namesOf(line);
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h," + spellings(kHelp, names), "this text");
  for (const OptionGroup& group : line.groups)
    for (const Option& option : group.options)
    {
      const bool positional = isPositional(option);
      const bool is_flag = !positional && option.value_name.empty();
      const std::string spelled = positional ? option.name : spellings(option.name, names);
      CLI::Option* const added = is_flag ? addFlag(app, option, spelled) : addValue(app, option, spelled);
      added->group(group.title);
      if (!positional) added->trigger_on_parse();  // in the order of the words: a later one may overrule an earlier one
    }
}

/// "SCENE.yaml": scene
std::string noun(const std::string& argument)
{
  std::string word = argument.substr(0, argument.find('.'));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// Of words that no option wanted.
void refuseLeftOver(const CLI::App& app, const CommandLine& line)
{
  const std::vector<std::string> words = app.remaining();
  if (words.empty()) return;
  if (words[0].size() > 1 && words[0][0] == '-')
    refuse(words[0], "unknown option", "one of those that --help lists: " + joined(namesOf(line)));
  for (const OptionGroup& group : line.groups)
    for (const Option& option : group.options)
      if (isPositional(option)) refuse(words[0], "second " + noun(option.name), "one " + noun(option.name));
  refuse(words[0], "no option", "one of those that --help lists: " + joined(namesOf(line)));
}

void refuseMissing(const CLI::App& app, const CommandLine& line)
{
  for (const OptionGroup& group : line.groups)
    for (const Option& option : group.options)
      if (option.required && app.get_option(option.name)->count() == 0)
        refuse(option.name, "missing", option.help + "; see --help");
}
}  // namespace

void refuse(const std::string& option, const std::string& value, const std::string& expected)
{
  throw UsageError(option + ": " + value + ": expected " + expected);
}

std::optional<std::string> parse(const CommandLine& line, int argc, const char* const* argv)
{
  CLI::App app(line.about + '\n', line.program);
  app.footer(line.footer);
  add(app, line);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    return app.help();
  }
  catch (const CLI::ArgumentMismatch&)  // only of the last word there can be none left
  {
    refuse(argv[argc - 1], "nothing", "a value after it");
  }
  catch (const CLI::ParseError& error)
  {
    refuseLeftOver(app, line);
    refuseMissing(app, line);
    throw UsageError(error.what());
  }
  return std::nullopt;
}

bool writeHelp(const std::string& help)
{
  return std::fputs(help.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
}
}  // namespace ping_pong
