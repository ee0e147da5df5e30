namespace Engraver.Core.Diagnostics;

/// <summary>Findings on the way from a toolpath to the commands of a motion controller: the drawing's size, the machine profile, the controller's
/// memory.</summary>
public static class MotionRules
{
    public static readonly DiagnosticRule OutsideCounts = new("MOT0001", Severity.Error, "x", "y", "scaleX", "scaleY");

    public static readonly DiagnosticRule NotFinite = new("MOT0002", Severity.Error);

    public static readonly DiagnosticRule ToolStartUnusable = new("MOT0003", Severity.Error, "x", "y");

    public static readonly DiagnosticRule SmallerThanACount = new("MOT0004", Severity.Warning, "x", "y");

    public static readonly DiagnosticRule ArcsBecomeChords = new("MOT0005", Severity.Info, "scaleX", "scaleY", "maxError");

    public static readonly DiagnosticRule SettingOutOfRange = new("MOT0006", Severity.Error, "setting", "value", "limit");

    public static readonly DiagnosticRule StrokeCutByMemory = new("MOT0007", Severity.Warning, "stroke", "lines", "x", "y");

    public static readonly DiagnosticRule ProfileUnreadable = new("MOT0008", Severity.Error, "reason");

    public static readonly DiagnosticRule ProfileFieldUnknown = new("MOT0009", Severity.Error, "field", "nearest");

    public static readonly DiagnosticRule ProfileValueUnreadable = new("MOT0010", Severity.Error, "field");

    public static readonly DiagnosticRule GapsBridged = new("MOT0011", Severity.Warning, "count", "off", "gap", "x", "y");

    public static readonly DiagnosticRule TooManyChords = new("MOT0012", Severity.Error, "count", "limit", "radius", "chords", "arcs");

    public static readonly DiagnosticRule RisingCurve = new("MOT0013", Severity.Error);

    public static readonly DiagnosticRule AboveRetract = new("MOT0014", Severity.Error, "z", "depth", "retract");

    public static readonly DiagnosticRule HeightOutsideCounts = new("MOT0015", Severity.Error, "z", "scale");

    public static readonly DiagnosticRule NoDepth = new("MOT0016", Severity.Warning);

    public static readonly DiagnosticRule WireTooSlow = new("MOT0020", Severity.Warning, "needed", "baud", "carried", "count", "feed", "wanted");

    public static readonly DiagnosticRule StopHandleReopened = new("MOT0021", Severity.Warning, "reason");

    public static readonly DiagnosticRule StopHandleLost = new("MOT0022", Severity.Warning, "reason", "failure");

    public static readonly DiagnosticRule ProfileContradiction = new("MOT0023", Severity.Warning, "setting", "value", "other");

    public static readonly DiagnosticRule UnattendedInParts = new("MOT0024", Severity.Warning, "programs", "lines");

    public static readonly DiagnosticRule MemoryTooSmall = new("MOT0025", Severity.Error, "needed", "lines");

    public static readonly DiagnosticRule ProfileFieldIgnored = new("MOT0026", Severity.Warning, "field");

    public static readonly DiagnosticRule SendingTooSlow = new("MOT0027", Severity.Warning, "wanted", "needed", "sent", "count", "feed");

    /// <summary>The connected network is too slow to send the segments at the feed.</summary>
    public static readonly DiagnosticRule NetworkTooSlow = new("MOT0028", Severity.Warning, "milliseconds", "carried", "wanted", "needed", "count", "feed");

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
    [
        OutsideCounts, NotFinite, ToolStartUnusable, SmallerThanACount, ArcsBecomeChords, SettingOutOfRange,
        StrokeCutByMemory, ProfileUnreadable, ProfileFieldUnknown, ProfileValueUnreadable, GapsBridged, TooManyChords, RisingCurve, AboveRetract, HeightOutsideCounts, NoDepth, WireTooSlow,
        StopHandleReopened, StopHandleLost, ProfileContradiction, UnattendedInParts, MemoryTooSmall, ProfileFieldIgnored, SendingTooSlow, NetworkTooSlow,
    ];
}
