namespace Engraver.Core.Diagnostics;

/// <summary>The findings of pockets. Lengths in the sentences are millimetres, areas square millimetres.</summary>
public static class PocketRules
{
    public static readonly DiagnosticRule TooNarrow = new("POC0001", Severity.Warning, "count", "width", "x", "y", "tool");

    public static readonly DiagnosticRule NotReached = new("POC0002", Severity.Info, "count", "area", "depth", "x", "y");

    public static readonly DiagnosticRule LeftStanding = new("POC0003", Severity.Error, "area", "x", "y");

    public static readonly DiagnosticRule NotClosed = new("POC0004", Severity.Error, "x", "y", "count");

    public static readonly DiagnosticRule NoInside = new("POC0005", Severity.Error);

    public static readonly DiagnosticRule WithoutInside = new("POC0006", Severity.Warning, "count");

    public static readonly DiagnosticRule NoRoomForScrew = new("POC0007", Severity.Info, "count", "x", "y");

    public static readonly DiagnosticRule NoRoomForRamp = new("POC0008", Severity.Warning, "count", "x", "y");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [TooNarrow, NotReached, LeftStanding, NotClosed, NoInside, WithoutInside, NoRoomForScrew, NoRoomForRamp];
}
