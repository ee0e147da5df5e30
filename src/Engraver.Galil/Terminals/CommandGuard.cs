using Engraver.Galil.Protocol;

namespace Engraver.Galil.Terminals;

/// <summary>Commands that a terminal does not send, or only after a word of confirmation.</summary>
public static class CommandGuard
{
    /// <summary>Why a line is withheld; null when it may be sent.</summary>
    /// <param name="line">One or more commands, separated by semicolons.</param>
    /// <param name="confirmed">The operator typed the word of confirmation.</param>
    public static string? WhyNot(string line, bool confirmed)
    {
        if (line.Length > CommandLine.MaximumLength) return Wording.Get("CommandGuard.LineHasCharactersController", line.Length, CommandLine.MaximumLength);
        if (line.Contains('\\', StringComparison.Ordinal) || line.Any(char.IsControl) || !line.All(char.IsAscii)) return Wording.Get("CommandGuard.ControllerTakesPrintableAscii");
        foreach (var part in CommandLine.Parts(line))
        {
            var command = part.Trim();
            if (NeverSent(command) is { } never) return never;
            if (!confirmed && Danger(command) is { } danger) return Wording.Get("CommandGuard.IfMeantWrite", command, danger, TerminalLine.ConfirmWord, line);
        }

        return null;
    }

    private static string? Danger(string command) => Letters(command) switch
    {
        "ST" when command.Length == 2 => Wording.Get("CommandGuard.StopsEveryMotionEnds"),
        "RS" => Wording.Get("CommandGuard.ResetsControllerWhichEnds"),
        "BN" => Wording.Get("CommandGuard.OverwritesBurnedParameters"),
        "BP" => Wording.Get("CommandGuard.OverwritesBurnedProgram"),
        "BV" => Wording.Get("CommandGuard.OverwritesBurnedVariables"),
        _ => null,
    };

    private static string? NeverSent(string command) => Letters(command) switch
    {
        "DL" or "QD" => Wording.Get("CommandGuard.DownloadWaitsLinesEnd"),
        "ED" => Wording.Get("CommandGuard.ControllerLineEditorCannot"),
        "QR" => Wording.Get("CommandGuard.QrAnswersBinaryAsk"),
        "QU" => Wording.Get("CommandGuard.QuAnswersWithoutLine"),
        _ => null,
    };

    /// <summary>The letters of a command; empty for an assignment or an operand.</summary>
    private static string Letters(string command) =>
        command.Length < 2 || (command.Length > 2 && char.IsAsciiLetterLower(command[2])) ? "" : command[..2];
}
