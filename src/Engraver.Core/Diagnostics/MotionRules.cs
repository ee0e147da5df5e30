namespace Engraver.Core.Diagnostics;

/// <summary>What can be wrong between a toolpath and the commands of a motion controller: the drawing's size, the machine profile, the controller's memory.</summary>
public static class MotionRules
{
    public static readonly DiagnosticRule OutsideCounts = new("MOT0001", Severity.Error,
        "The entity reaches {x}, {y} mm, which at {scaleX} x {scaleY} counts per mm cannot be counted in the controller's 32 bits.",
        "Move the drawing nearer to its origin, correct its units, or correct the counts per millimetre of the machine profile.");

    public static readonly DiagnosticRule NotFinite = new("MOT0002", Severity.Error,
        "The entity has a coordinate that is not a number or is infinite.",
        "Repair or delete the entity in the CAD program.");

    public static readonly DiagnosticRule ToolStartUnusable = new("MOT0003", Severity.Error,
        "The tool start {x}, {y} mm cannot be counted in the controller's 32 bits.",
        "Give a start point near the drawing.");

    public static readonly DiagnosticRule SmallerThanACount = new("MOT0004", Severity.Warning,
        "The stroke at {x}, {y} mm is shorter than one count of the machine and is not cut.",
        "Check the units of the drawing, or delete the entity.");

    public static readonly DiagnosticRule ArcsBecomeChords = new("MOT0005", Severity.Info,
        "The axes have {scaleX} and {scaleY} counts per mm, so every arc is cut as chords within {maxError} mm.",
        "Nothing needs to be done; equal counts per mm on both axes would let the controller cut true arcs.");

    public static readonly DiagnosticRule SettingOutOfRange = new("MOT0006", Severity.Error,
        "The machine profile sets {setting} to {value}; it must be {limit}.",
        "Correct the setting in the machine profile.");

    public static readonly DiagnosticRule StrokeCutByMemory = new("MOT0007", Severity.Warning,
        "Stroke {stroke} does not fit the controller's memory of {lines} lines; the tool lifts at {x}, {y} counts and the stroke goes on in the next chunk.",
        "Run the job as a stream if the mark of the standstill matters.");

    public static readonly DiagnosticRule ProfileUnreadable = new("MOT0008", Severity.Error,
        "The machine profile cannot be read: {reason}.",
        "Correct the file; its fields are those of the default machine profile.");

    public static readonly DiagnosticRule ProfileFieldUnknown = new("MOT0009", Severity.Error,
        "The machine profile has the field {field}, which does not exist.",
        "Correct its spelling (upper and lower case count) or delete it.");

    public static readonly DiagnosticRule ProfileValueUnreadable = new("MOT0010", Severity.Error,
        "The machine profile gives {field} a value that is no number, or no whole number where one is needed, or gives it twice.",
        "Write the field once, as a number with a decimal point and without quotation marks.");

    public static readonly DiagnosticRule GapsBridged = new("MOT0011", Severity.Warning,
        "Gaps within the join tolerance are cut straight across, and in {count} of them the tool is farther beside the drawing than rounding and curve error take it: up to {off} mm in the widest, which is {gap} mm at {x}, {y}.",
        "Close the gaps in the drawing, or lower [join-tolerance] to have them shown as open ends.");

    public static readonly DiagnosticRule TooManyChords = new("MOT0012", Severity.Error,
        "The drawing needs {count} chords, and {limit} is the most; this entity, of radius {radius} mm, needs {chords} of them. The controller cuts {arcs}; others become chords.",
        "Correct the units or the scale of the drawing, draw nearly straight arcs as lines, or allow a larger curve error ([max-error]).");

    public static readonly DiagnosticRule WireTooSlow = new("MOT0020", Severity.Warning,
        "At full feed the path needs {needed} segments a second and {baud} baud carry {carried}, so the feed is lowered in {count} of the vector sequences, at worst to {feed} instead of {wanted} mm/min.",
        "Set a faster line, connect over TCP, allow a larger curve error, or choose a feed that suits the whole part.");

    public static readonly DiagnosticRule StopHandleReopened = new("MOT0021", Severity.Warning,
        "The second handle, over which the stop goes, was lost while the job ran ({reason}) and was opened again.",
        "Look for what cut it: the cable, the network, or somebody who closed handles of the controller.");

    public static readonly DiagnosticRule StopHandleLost = new("MOT0022", Severity.Warning,
        "The second handle, over which the stop goes, was lost while the job runs ({reason}) and could not be opened again ({failure}).",
        "The stop still works, but over the handle of the job: it goes behind the command under way.");

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
    [
        OutsideCounts, NotFinite, ToolStartUnusable, SmallerThanACount, ArcsBecomeChords, SettingOutOfRange,
        StrokeCutByMemory, ProfileUnreadable, ProfileFieldUnknown, ProfileValueUnreadable, GapsBridged, TooManyChords, WireTooSlow,
        StopHandleReopened, StopHandleLost,
    ];
}
