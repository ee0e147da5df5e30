using Engraver.Galil.Protocol;

namespace Engraver.Galil.Terminals;

/// <summary>Commands that a terminal does not send, or only after a confirmation.</summary>
public static class CommandGuard
{
    /// <summary>The reason why a line is withheld; null when it may be sent.</summary>
    /// <param name="line">One or more commands, separated by semicolons.</param>
    /// <param name="confirmed">The operator typed the confirmation.</param>
    public static string? ReasonToWithhold(string line, bool confirmed)
    {
        if (line.Length > CommandLine.MaximumLength) return Wording.Get("CommandGuard.LineTooLong", line.Length, CommandLine.MaximumLength);
        if (line.Contains('\\', StringComparison.Ordinal) || line.Any(char.IsControl) || !line.All(char.IsAscii)) return Wording.Get("CommandGuard.InvalidCharacters");
        foreach (var part in CommandLine.Parts(line))
        {
            var command = part.Trim();
            if (ReasonNotSent(command) is { } never) return never;
            if (!confirmed && Danger(command) is { } danger) return Wording.Get(danger, command, TerminalLine.ConfirmWord, line);
        }

        return null;
    }

    /// <summary>Name of the text that asks for confirmation; null for a command that needs none.</summary>
    private static string? Danger(string command) => Letters(command) switch
    {
        "ST" when command.Length == 2 => "CommandGuard.ConfirmStopOfAll",
        "RS" => "CommandGuard.ConfirmReset",
        "BN" => "CommandGuard.ConfirmParameters",
        "BP" => "CommandGuard.ConfirmProgram",
        "BV" => "CommandGuard.ConfirmVariables",
        _ => null,
    };

    private static string? ReasonNotSent(string command) => Letters(command) switch
    {
        "DL" or "QD" => Wording.Get("CommandGuard.Download"),
        "ED" => Wording.Get("CommandGuard.LineEditor"),
        "QR" => Wording.Get("CommandGuard.BinaryReply"),
        "QU" => Wording.Get("CommandGuard.ReplyWithoutLineEnd"),
        _ => null,
    };

    /// <summary>The letters of a command; empty for an assignment or an operand.</summary>
    private static string Letters(string command) =>
        command.Length < 2 || (command.Length > 2 && char.IsAsciiLetterLower(command[2])) ? "" : command[..2];
}
