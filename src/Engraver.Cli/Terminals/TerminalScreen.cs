using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Cli.Terminals;

/// <summary>Shows answers as plain text, or coloured on an interactive terminal.</summary>
internal sealed class TerminalScreen(TextWriter output, bool coloured)
{
    private const string Prompt = "engraver> ";
    private const string ClearLine = "\r\e[K";
    private const string Plain = "\e[0m";

    public void Show(TerminalAnswer answer)
    {
        if (answer.Text.Length == 0) return;
        foreach (var line in answer.Text.Split('\n')) output.WriteLine(Coloured(answer.Kind, answer.Kind == TerminalAnswerKind.Message ? "* " + line : line));
        output.Flush();
    }

    /// <summary>The line being typed, with the cursor at its position.</summary>
    public void ShowInput(string text, int cursor)
    {
        output.Write(string.Create(CultureInfo.InvariantCulture, $"{ClearLine}{Prompt}{text}\r\e[{Prompt.Length + cursor}C"));
        output.Flush();
    }

    /// <summary>Clears the line being typed, so that a message can be written in its place.</summary>
    public void HideInput() => output.Write(ClearLine);

    public void EndInput() => output.WriteLine();

    private string Coloured(TerminalAnswerKind kind, string line) => !coloured ? line : kind switch
    {
        TerminalAnswerKind.Refusal or TerminalAnswerKind.Withheld => $"\e[31m{line}{Plain}",
        TerminalAnswerKind.Message => $"\e[33m{line}{Plain}",
        TerminalAnswerKind.Help => $"\e[36m{line}{Plain}",
        _ => $"\e[32m{line}{Plain}",
    };
}
