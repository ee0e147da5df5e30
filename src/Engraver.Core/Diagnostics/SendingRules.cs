namespace Engraver.Core.Diagnostics;

/// <summary>Findings about a program that is to be sent over a serial line to a control.</summary>
public static class SendingRules
{
    public static readonly DiagnosticRule NothingToSend = new("SND0001", Severity.Error);

    public static readonly DiagnosticRule CharacterTooLarge = new("SND0002", Severity.Error, "code", "column", "line", "frame");

    public static readonly DiagnosticRule TooManyBlocks = new("SND0003", Severity.Error, "blocks", "limit");

    public static readonly DiagnosticRule SeveralPrograms = new("SND0004", Severity.Error, "count");

    public static readonly DiagnosticRule NoSuchProgram = new("SND0005", Severity.Error, "number", "count");

    public static readonly DiagnosticRule ParityWrong = new("SND0006", Severity.Error, "count", "line", "frame");

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [NothingToSend, CharacterTooLarge, TooManyBlocks, SeveralPrograms, NoSuchProgram, ParityWrong];
}
