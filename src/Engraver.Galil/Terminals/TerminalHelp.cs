using System.Globalization;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Terminals;

/// <summary>Help for the terminal, for a command, or for the number that TC gave.</summary>
public static class TerminalHelp
{
    /// <param name="subject">Empty, a command (VP, _RPA, PR 100), or a number (22).</param>
    public static string About(string subject)
    {
        if (subject.Length == 0) return General();
        if (int.TryParse(subject, NumberStyles.None, CultureInfo.InvariantCulture, out var number)) return OfCode((TcCode)number);
        return CommandHelpTable.TryFind(subject, out var help) ? help.ToString() : $"'{subject}' is no command of the DMC-21x3; help lists them all.";
    }

    private static string OfCode(TcCode code) => Enum.IsDefined(code) && code != TcCode.None
        ? $"TC {(int)code}  {TcCodes.Text(code)}{TcCodes.Hint(code)}"
        : $"TC {(int)code} is not defined.";

    private static string General()
    {
        var commands = CommandHelpTable.All.Select(help => help.Command).Chunk(20).Select(row => "  " + string.Join(' ', row));
        return string.Join('\n', [
            "A line goes to the controller as it is; its answer follows (: when it has nothing to say, ? and the reason when it refuses).",
            "help VP  a command        help 22  a TC code        history  lines so far        quit  ends",
            $"{TerminalLine.ConfirmWord} RS  for what stops or overwrites everything (bare ST, RS, BN, BP, BV)",
            "Commands of the DMC-21x3:",
            .. commands]);
    }
}
