using Engraver.Workbench.Commands;

namespace Engraver.App.CommandWindow;

/// <summary>A displayed line of the history; a message of several lines becomes several lines.</summary>
public sealed record HistoryLine(MessageKind Kind, string Text)
{
    /// <summary>Maximum number of displayed lines of one message, which may have a million.</summary>
    private const int MaxLinesPerMessage = 2000;

    public bool IsError => Kind == MessageKind.Error;

    public bool IsWarning => Kind == MessageKind.Warning;

    public bool IsNote => Kind == MessageKind.Note;

    public static IEnumerable<HistoryLine> From(CommandMessage message)
    {
        var lines = message.Text.Split('\n', MaxLinesPerMessage + 1);
        for (var at = 0; at < Math.Min(lines.Length, MaxLinesPerMessage); at++) yield return new HistoryLine(message.Kind, lines[at]);
        if (lines.Length > MaxLinesPerMessage) yield return new HistoryLine(MessageKind.Note, Texts.Text.Get("Command.MoreLines", Texts.Text.Count("Count.Line", lines[^1].AsSpan().Count('\n') + 1)));
    }
}
