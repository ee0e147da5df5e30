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

    public static readonly DiagnosticRule StartsElsewhere = new("JOB0006", Severity.Warning,
        "The machine stands at {here} mm, and that place is taken for the drawing's start {start}; the last run of this drawing on this controller ({when}) had the start at {there} mm, so this one is cut {dx}, {dy} mm beside it.",
        "Stop, and go back with [goto-start], when it is the same work piece; nothing, when it is another one.");

    public static readonly DiagnosticRule StartNotKept = new("JOB0007", Severity.Warning,
        "Where this run starts could not be written down: {reason}.",
        "Nothing for this run; the next one of this drawing cannot say whether it starts in the same place.");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [NotCut, NotLevel, SeveralHeights, OneHeight, TooLarge, StartsElsewhere, StartNotKept];
}
