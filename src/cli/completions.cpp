#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "io/text_file.h"

namespace flexslip {
namespace {

// The program for the completion scripts.
struct Flag {
  std::string name;         // with its dashes
  std::string description;  // one line
  bool takes_value;
};

struct Verb {
  std::string name;
  std::string description;
  std::vector<Flag> flags;
};

std::vector<Flag> flags_of(const CLI::App& app) {
  std::vector<Flag> flags;
  for (const CLI::Option* option : app.get_options()) {
    const bool takes_value = option->get_expected_min() > 0;
    for (const std::string& name : option->get_lnames())
      flags.push_back({"--" + name, option->get_description(), takes_value});
    for (const std::string& name : option->get_snames())
      flags.push_back({"-" + name, option->get_description(), takes_value});
  }
  return flags;
}

std::vector<Verb> verbs_of(const CLI::App& app) {
  std::vector<Verb> verbs;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back({command->get_name(), command->get_description(), flags_of(*command)});
  return verbs;
}

std::string names_of(const std::vector<Flag>& flags) {
  std::string out;
  for (const Flag& flag : flags) out += (out.empty() ? "" : " ") + flag.name;
  return out;
}

std::string bash_script(const CLI::App& app) {
  std::string cases;
  std::string names;
  for (const Verb& verb : verbs_of(app)) {
    names += verb.name + " ";
    cases += fmt::format("    {}) words={} ;;\n", verb.name, shell_word(names_of(verb.flags)));
  }
  return fmt::format(R"(# bash completion for flexslip, written by: flexslip completions bash
_flexslip() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} words
  case ${{COMP_WORDS[1]}} in
{}    *) words={} ;;
  esac
  if ((COMP_CWORD == 1)); then
    words={}
  elif [[ $current != -* ]]; then
    words=
    if [[ ${{COMP_WORDS[1]}} == completions ]]; then words='bash zsh fish'; fi
  fi
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o bashdefault -o default -F _flexslip flexslip
)",
                     cases, shell_word(names_of(flags_of(app))), shell_word(names + names_of(flags_of(app))));
}

// The text of a description inside the brackets of zsh's _arguments.
std::string zsh_description(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_arguments(const std::vector<Flag>& flags, std::string_view rest) {
  std::string out = "_arguments";
  for (const Flag& flag : flags)
    out +=
        fmt::format(" \\\n        {}", shell_word(fmt::format("{}[{}]{}", flag.name, zsh_description(flag.description),
                                                              flag.takes_value ? ":value:_files" : "")));
  return out + fmt::format(" \\\n        {}", shell_word(rest));
}

std::string zsh_script(const CLI::App& app) {
  std::string names;
  std::string cases;
  for (const Verb& verb : verbs_of(app)) {
    names += fmt::format("    {}\n", shell_word(verb.name + ":" + zsh_description(verb.description)));
    cases += fmt::format(
        "    {})\n      {}\n      ;;\n", verb.name,
        zsh_arguments(verb.flags, verb.name == "completions" ? "1:shell:(bash zsh fish)" : "*:file:_files"));
  }
  return fmt::format(R"(#compdef flexslip
# zsh completion for flexslip, written by: flexslip completions zsh
_flexslip() {{
  local -a commands=(
{}  )
  if ((CURRENT == 2)); then
    _describe command commands
    {}
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{}  esac
}}
if [[ $funcstack[1] == _flexslip ]]; then _flexslip "$@"; else compdef _flexslip flexslip; fi
)",
                     names, zsh_arguments(flags_of(app), "*: :"), cases);
}

std::string fish_flags(const std::vector<Flag>& flags, std::string_view condition) {
  std::string out;
  for (const Flag& flag : flags) {
    const bool is_long = flag.name.starts_with("--");
    out += fmt::format("complete -c flexslip -n {} {} {}{} -d {}\n", shell_word(condition), is_long ? "-l" : "-s",
                       flag.name.substr(is_long ? 2 : 1), flag.takes_value ? " -r" : "", shell_word(flag.description));
  }
  return out;
}

std::string fish_script(const CLI::App& app) {
  std::string out = "# fish completion for flexslip, written by: flexslip completions fish\n";
  out += fish_flags(flags_of(app), "__fish_use_subcommand");
  for (const Verb& verb : verbs_of(app)) {
    out += fmt::format("complete -c flexslip -f -n '__fish_use_subcommand' -a {} -d {}\n", verb.name,
                       shell_word(verb.description));
    out += fish_flags(verb.flags, "__fish_seen_subcommand_from " + verb.name);
  }
  return out + "complete -c flexslip -f -n '__fish_seen_subcommand_from completions' -a 'bash zsh fish'\n";
}

struct CompletionsRequest {
  const CLI::App* app;
  std::string shell;
  std::string path = "-";
};

void run_completions(const CompletionsRequest& request) {
  const CLI::App& app = *request.app;
  write_text(request.path, request.shell == "bash"  ? bash_script(app)
                           : request.shell == "zsh" ? zsh_script(app)
                                                    : fish_script(app));
}

}  // namespace

void add_completions_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "completions", "A script that lets a shell complete the program's commands and options", run_completions);
  request.app = &app;
  add_option(command, "shell SHELL", request.shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  add_output_option(command, request.path);
  command.footer(
      "Examples:\n"
      "  source <(flexslip completions bash)\n"
      "  flexslip completions fish --output ~/.config/fish/completions/flexslip.fish");
}

}  // namespace flexslip
