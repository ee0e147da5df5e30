namespace Engraver.Core.Diagnostics;

/// <summary>The findings of placing a drawing.</summary>
public static class PlacementRules
{
    public static readonly DiagnosticRule OutOfRange = new("PLC0001", Severity.Error);

    public static readonly DiagnosticRule NothingToPlace = new("PLC0002", Severity.Error);

    public static readonly DiagnosticRule OutsideBlank = new("PLC0003", Severity.Warning, "distance");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [OutOfRange, NothingToPlace, OutsideBlank];
}
