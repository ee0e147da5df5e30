namespace Engraver.Core.Diagnostics;

/// <summary>Findings before a job is run, when not everything visible is cut or it would be cut in another place. Lengths in the sentences are millimetres.</summary>
public static class PreparationRules
{
    public static readonly DiagnosticRule NotCut = new("JOB0001", Severity.Warning,
        "{counts} visible and {are} not cut.",
        "Turn texts into lines in the CAD program where they have to be engraved, name outlines with [cut] (hatch, mline, leader, helix, solid), or put what is not meant on a layer that is off or not plotted.");

    public static readonly DiagnosticRule NotLevel = new("JOB0002", Severity.Warning,
        "{curves}, the first between the heights {low} and {high} mm; they are cut flat, as seen from above, at the tool's one height.",
        "Give every point the height 0 in the CAD program (FLATTEN) when flat is meant; this machine cannot cut the slope.");

    public static readonly DiagnosticRule SeveralHeights = new("JOB0003", Severity.Warning,
        "The curves lie at {count} heights, from {low} to {high} mm; all are cut at the tool's one height, and curves at different heights are not joined.",
        "Bring to one height in the CAD program what belongs together, and leave out by its layer ([skip-layers]) what is not meant to be cut.");

    public static readonly DiagnosticRule OneHeight = new("JOB0004", Severity.Info,
        "The whole drawing lies at the height {z} mm; it is cut at the tool's one height.",
        "Nothing, when that is meant.");

    public static readonly DiagnosticRule TooLarge = new("JOB0005", Severity.Warning,
        "What is cut measures {width} x {height} mm and reaches {distance} mm from the tool's start; more than {size} mm of size or {far} mm of distance is no work for an engraver{guess}.",
        "Check the unit ([units-mm] or [units-inch]), move the drawing to its origin or give [start] near it, scale it, or cut a part of it ([layers]).");

    public static readonly DiagnosticRule NoOrigin = new("JOB0008", Severity.Error,
        "The work origin {name} is not set on this machine, and the machine stands at {x}, {y} mm by its own zero.",
        "Move the tool to the drawing's zero and set the origin there ([zero]), or give [origin-here] when the machine stands at the drawing's start point.");

    public static readonly DiagnosticRule ZeroLost = new("JOB0009", Severity.Error,
        "The controller was switched off or reset since the work origin {name} was last used; it counts from another place now, and the origin is nowhere.",
        "Home the machine or move the tool to the drawing's zero, set the origin again ([zero]), or give [origin-here] when the machine stands at the drawing's start point.");

    public static readonly DiagnosticRule PositionDoubted = new("JOB0010", Severity.Error,
        "The machine's position is not to be trusted: {reason}.",
        "Switch the motors on, home the machine or move the tool to the drawing's zero, and set the origin again ([zero]); or give [origin-here] when the machine stands at the drawing's start point.");

    public static readonly DiagnosticRule OriginHalfSet = new("JOB0011", Severity.Error,
        "The work origin {name} has no place for {axis}.",
        "Set it ([zero]), or give [origin-here] when the machine stands at the drawing's start point.");

    public static readonly DiagnosticRule OriginTooFar = new("JOB0012", Severity.Error,
        "The origin {x}, {y} mm is farther from the controller's zero than it can count.",
        "Give a place nearer to its zero.");

    public static readonly DiagnosticRule StateNotKept = new("JOB0013", Severity.Warning,
        "Where the work is could not be written down: {reason}.",
        "Make room or let the file be written; until then the next session does not know this machine's origins.");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [NotCut, NotLevel, SeveralHeights, OneHeight, TooLarge, NoOrigin, ZeroLost, PositionDoubted, OriginHalfSet, OriginTooFar, StateNotKept];
}
