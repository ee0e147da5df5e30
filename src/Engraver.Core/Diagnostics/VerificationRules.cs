namespace Engraver.Core.Diagnostics;

/// <summary>Errors of a program that is read back and replayed (lines are lines of the program's file), and of a toolpath that is compared with its
/// drawing.</summary>
public static class VerificationRules
{
    public static readonly DiagnosticRule ProgramEmpty = new("VER0001", Severity.Error);

    public static readonly DiagnosticRule NoJobLabel = new("VER0002", Severity.Error);

    public static readonly DiagnosticRule ChunksIncomplete = new("VER0003", Severity.Error, "expected", "count", "line");

    public static readonly DiagnosticRule LineUnusable = new("VER0004", Severity.Error, "reason");

    public static readonly DiagnosticRule NotLoaded = new("VER0005", Severity.Error, "code", "text");

    public static readonly DiagnosticRule LineRefused = new("VER0006", Severity.Error, "line", "code", "text");

    public static readonly DiagnosticRule Endless = new("VER0007", Severity.Error, "reason");

    public static readonly DiagnosticRule CutBesideDrawing = new("VER0008", Severity.Error, "deviation", "x", "y", "tolerance");

    public static readonly DiagnosticRule NotCut = new("VER0009", Severity.Error, "length", "x", "y");

    public static readonly DiagnosticRule OtherFeed = new("VER0010", Severity.Error, "feed", "line", "expected");

    public static readonly DiagnosticRule BlendsTooFar = new("VER0011", Severity.Error, "blend", "line", "deviation", "tolerance");

    public static readonly DiagnosticRule BlendsWithoutBound = new("VER0012", Severity.Error, "line");

    public static readonly DiagnosticRule OtherThanAsked = new("VER0013", Severity.Error, "said", "line", "expected");

    public static readonly DiagnosticRule CutTwice = new("VER0014", Severity.Error, "length", "expected");

    public static readonly DiagnosticRule OtherPace = new("VER0015", Severity.Error, "x", "y", "seconds", "wait", "expected", "expectedWait");

    public static readonly DiagnosticRule ToolpathBeside = new("VER0020", Severity.Error, "deviation", "x", "y", "tolerance");

    public static readonly DiagnosticRule ToolpathMissing = new("VER0021", Severity.Error, "length", "x", "y");

    public static readonly DiagnosticRule ToolpathExtra = new("VER0022", Severity.Error, "length", "x", "y");

    public static readonly DiagnosticRule LettersMisplaced = new("VER0023", Severity.Error, "text", "distance", "x", "y");

    public static readonly DiagnosticRule FontsChanged = new("VER0024", Severity.Error, "fonts", "certificate");

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
        [ProgramEmpty, NoJobLabel, ChunksIncomplete, LineUnusable, NotLoaded, LineRefused, Endless, CutBesideDrawing, NotCut, OtherFeed, BlendsTooFar, BlendsWithoutBound, OtherThanAsked, CutTwice, OtherPace, ToolpathBeside, ToolpathMissing, ToolpathExtra, LettersMisplaced, FontsChanged];
}
