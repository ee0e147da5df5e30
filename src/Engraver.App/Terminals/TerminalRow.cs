using System.Globalization;
using Engraver.Workbench.Terminals;

namespace Engraver.App.Terminals;

/// <summary>A line of the conversation with the controller.</summary>
public sealed record TerminalRow(string Time, string Text, bool IsTyped, bool IsRefusal, bool IsQuiet)
{
    public static IEnumerable<TerminalRow> Of(TerminalEntry entry)
    {
        var time = entry.Time.ToLocalTime().ToString("HH:mm:ss.fff", CultureInfo.InvariantCulture);
        foreach (var line in entry.Text.Split('\n'))
        {
            yield return new TerminalRow(time, entry.Kind is null ? "> " + line : line, entry.Kind is null, entry.Kind is TerminalAnswerKind.Refusal or TerminalAnswerKind.Withheld, entry.Kind is TerminalAnswerKind.Help or TerminalAnswerKind.Message);
        }
    }
}
