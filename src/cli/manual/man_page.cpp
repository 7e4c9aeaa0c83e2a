#include "manual/man_page.h"

#include <sstream>

namespace softgl::cli {
namespace {

// Text as it shall stand on the page: dashes for copying, no control lines.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '-': result += "\\-"; break;
    case '\\': result += "\\e"; break;
    case '\'': result += "\\(aq"; break;
    case '`': result += "\\(ga"; break;
    case '^': result += "\\(ha"; break;
    case '~': result += "\\(ti"; break;
    case '"': result += "\\(dq"; break;
    default: result += c;
    }
  }
  return !result.empty() && result.front() == '.' ? "\\&" + result : result;
}

std::string page_name(const CommandRow& command) {
  return command.program + (command.word.empty() ? "" : "-" + command.word);
}

std::string operands(const CommandRow& command) {
  std::string text;
  for (const OptionRow& operand : command.operands) {
    const std::string name = "\\fI" + escaped(operand.value) + "\\fR" + (operand.many ? " ..." : "");
    text += operand.required ? " " + name : " [" + name + "]";
  }
  return text;
}

std::string option_entry(const OptionRow& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + ("\\fB" + escaped(name) + "\\fR");
  if (!option.value.empty()) names += " \\fI" + escaped(option.value) + "\\fR";
  return ".TP\n" + names + "\n" + escaped(option.text) + "\n";
}

std::string paragraphs(const std::string& notes) {
  std::istringstream lines(notes);
  std::string text;
  for (std::string line; std::getline(lines, line);) text += line.empty() ? ".PP\n" : escaped(line) + "\n";
  return text;
}

// Where options come from that the command line does not give; the same on all pages.
constexpr const char* kSettings =
    R"(.SH SETTINGS
An option that the command line does not give is taken from the environment, else from a file, else it has its default.
.TP
\fBSOFTGL_OPT_\fINAME\fR
The value of an option: its long name in capitals, with _ for each dash between words.
SOFTGL_OPT_LINE_WIDTH=2 is \-\-line\-width 2, SOFTGL_OPT_ORTHO=true is \-\-ortho.
.TP
\fB$XDG_CONFIG_HOME/softgl/config\fR, \fB~/.config/softgl/config\fR
The user\(aqs own file, read if it exists.
SOFTGL_OPT_CONFIG or \-\-config names another one; with an empty name none is read.
A line is \fINAME\fR = \fIVALUE\fR, the name being a long one without dashes; a line that begins with # is a comment.
Lines below [\fICOMMAND\fR] are for that command alone, the others for each command that has the option.
A line may be repeated where the option may.
.PP
.EX
size = 1920x1080
ortho = true
light = headlight
[compare]
tolerance = 2
.EE
.PP
A setting that is wrong ends the run with exit code 2 and a sentence that names its variable, or its file and line.
)";

} // namespace

std::string man_page(const CommandRow& program, const CommandRow& command) {
  const std::string name = page_name(command);
  std::string page = "." + std::string("TH ") + escaped(name) + " 1 \"\" \"softgl " SOFTGL_VERSION "\"\n";
  const std::string who = command.program + " ";
  const bool says_who = command.text.rfind(who, 0) == 0;
  page +=
      ".SH NAME\n" + escaped(name) + " \\- " + escaped(command.text.substr(says_who ? who.size() : 0)) + "\n";
  page += ".SH SYNOPSIS\n.B " + escaped(command.program) +
          (command.word.empty() ? "" : " " + escaped(command.word)) + "\n[\\fIOPTIONS\\fR]" +
          operands(command) + "\n";
  for (const CommandRow& each : command.commands)
    page += ".br\n.B softgl " + escaped(each.word) + "\n[\\fIOPTIONS\\fR]" + operands(each) + "\n";
  page += ".SH OPERANDS\n";
  for (const OptionRow& operand : command.operands)
    page += ".TP\n\\fI" + escaped(operand.value) + "\\fR\n" + escaped(operand.text) + "\n";
  page += ".SH OPTIONS\n";
  std::string group = command.options.empty() ? "" : command.options.back().group;
  for (const OptionRow& option : command.options) {
    if (option.group != group) page += ".SS " + escaped(option.group) + "\n";
    group = option.group;
    page += option_entry(option);
  }
  if (command.takes_program_options) page += ".PP\nAnd the options of a picture; see\n.BR softgl (1).\n";
  if (!command.commands.empty()) page += ".SH COMMANDS\n";
  for (const CommandRow& each : command.commands)
    page += ".TP\n.BR softgl\\-" + escaped(each.word) + " (1)\n" + escaped(each.text) + "\n";
  page += kSettings + std::string(".SH NOTES\n") + paragraphs(command.notes);
  if (!command.examples.empty()) page += ".SH EXAMPLES\n";
  for (const std::string& example : command.examples) page += ".PP\n.EX\n" + escaped(example) + "\n.EE\n";
  page += ".SH SEE ALSO\n";
  std::string separator;
  for (const CommandRow* each = &program; each != program.commands.data() + program.commands.size();
       each = each == &program ? program.commands.data() : each + 1)
    if (page_name(*each) != name) {
      page += separator + ".BR " + escaped(page_name(*each)) + " (1)";
      separator = ",\n";
    }
  return page + "\n";
}

} // namespace softgl::cli
