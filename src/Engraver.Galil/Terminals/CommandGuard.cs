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
        if (line.Length > CommandLine.MaximumLength) return $"The line has {line.Length} characters; the controller takes {CommandLine.MaximumLength}.";
        if (line.Contains('\\', StringComparison.Ordinal) || line.Any(char.IsControl) || !line.All(char.IsAscii)) return "The controller takes printable ASCII without a backslash.";
        foreach (var part in CommandLine.Parts(line))
        {
            var command = part.Trim();
            if (NeverSent(command) is { } never) return never;
            if (!confirmed && Danger(command) is { } danger) return $"'{command}' {danger}; if that is meant, write: {TerminalLine.ConfirmWord} {line}";
        }

        return null;
    }

    private static string? Danger(string command) => Letters(command) switch
    {
        "ST" when command.Length == 2 => "stops every motion and ends all programs, ST AB or STS only brakes what it names",
        "RS" => "resets the controller, which ends motion, programs and this connection",
        "BN" => "overwrites the burned parameters",
        "BP" => "overwrites the burned program",
        "BV" => "overwrites the burned variables",
        _ => null,
    };

    private static string? NeverSent(string command) => Letters(command) switch
    {
        "DL" or "QD" => "A download waits for lines and an end mark, which a terminal cannot send; use run or post.",
        "ED" => "The controller's line editor cannot be used here; its answers have no prompt.",
        "QR" => "QR answers in binary; ask with MG instead, for example MG _RPA,_RPB.",
        "QU" => "QU answers without a line end; ask for one value with MG name[0].",
        _ => null,
    };

    /// <summary>The letters of a command; empty for an assignment or an operand.</summary>
    private static string Letters(string command) =>
        command.Length < 2 || (command.Length > 2 && char.IsAsciiLetterLower(command[2])) ? "" : command[..2];
}
