using System.Globalization;
using Engraver.Core.Languages;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Terminals;

/// <summary>Help for the terminal, for a command, or for a TC code.</summary>
public static class TerminalHelp
{
    /// <param name="subject">Empty, a command (VP, _RPA, PR 100), or a number (22).</param>
    public static string About(string subject)
    {
        if (subject.Length == 0) return General();
        if (int.TryParse(subject, NumberStyles.None, CultureInfo.InvariantCulture, out var number)) return OfCode((TcCode)number);
        return CommandHelpTable.TryFind(subject, out var help) ? help.ToString() : Wording.Get("TerminalHelp.UnknownCommand", subject);
    }

    private static string OfCode(TcCode code) => Enum.IsDefined(code) && code != TcCode.None
        ? Wording.Get("TerminalHelp.OfCode", (int)code, TcCodes.Text(code), TcCodes.Hint(code))
        : Wording.Get("TerminalHelp.TcNotDefined", (int)code);

    private static string General()
    {
        var commands = CommandHelpTable.All.Select(help => help.Command).Chunk(20).Select(row => "  " + TextCatalogue.Fact(string.Join(' ', row)));
        return string.Join('\n', [
            Wording.Get("TerminalHelp.HowLinesAreSent"),
            Wording.Get("TerminalHelp.Words"),
            Wording.Get("TerminalHelp.ConfirmWord", TerminalLine.ConfirmWord),
            Wording.Get("TerminalHelp.CommandsDmc"),
            .. commands]);
    }
}
