namespace Engraver.Core.Diagnostics;

/// <summary>The findings of sequencing. Lengths in the sentences are millimetres.</summary>
public static class SequencingRules
{
    public static readonly DiagnosticRule DuplicatesRemoved = new("SEQ0001", Severity.Info,
        "{count} segments lie on another one and are cut once; the first is entity {handle}.",
        "Delete the doubles in the drawing, or keep them [+keep-duplicates].");

    public static readonly DiagnosticRule OpenEnds = new("SEQ0002", Severity.Info,
        "{count} ends of open contours have no other open end within {gap} mm; the first is at {x}, {y}.",
        "Nothing, when these contours are meant to be open.");

    public static readonly DiagnosticRule SmallGap = new("SEQ0003", Severity.Warning,
        "The contour is open at {x}, {y}: the nearest other open end is {gap} mm away, on entity {handle}.",
        "Close the gap in the drawing, or raise [join-tolerance] above it.");

    public static readonly DiagnosticRule ShortSegments = new("SEQ0004", Severity.Info,
        "{count} segments are no longer than the join tolerance of {tolerance} mm; the first is at {x}, {y}.",
        "Nothing, when such detail is meant; otherwise lower [join-tolerance] or clean the drawing.");

    public static readonly DiagnosticRule EntryNotFound = new("SEQ0006", Severity.Warning,
        "The entering entity is not among what is cut; the order starts at the nearest stroke.",
        "Name an entity on a layer that is cut, or a point near one.");

    public static readonly DiagnosticRule EntryWaits = new("SEQ0007", Severity.Info,
        "The entering stroke directly encloses {count} others, which are cut before it.",
        "Enter at one of the strokes inside when one of those must be first.");

    public static readonly DiagnosticRule NothingToCut = new("SEQ0008", Severity.Warning,
        "Nothing is left to cut: no curve stands on a layer that is cut.",
        "Check which layers are visible, not frozen and plottable, or name layers with [layers].");

    public static readonly DiagnosticRule Branches = new("SEQ0009", Severity.Info,
        "At {count} places a contour could have gone on in several ways; the straightest was taken, then the lower row.",
        "Look at the numbered strokes when the order matters there.");

    public static readonly DiagnosticRule ArcRecovered = new("SEQ0010", Severity.Info,
        "{count} lines from {x}, {y} on are cut as one arc of radius {radius} mm, at most {deviation} mm from them.",
        "Cut [-recover-arcs], or lower [max-error], when the lines are meant.");

    public static readonly DiagnosticRule CircleRecovered = new("SEQ0011", Severity.Info,
        "{count} lines around {x}, {y} are cut as one circle of radius {radius} mm, at most {deviation} mm from them.",
        "Cut [-recover-arcs], or lower [max-error], when the lines are meant.");

    public static readonly DiagnosticRule EntryStandsIn = new("SEQ0012", Severity.Info,
        "The entering entity {handle} was drawn twice or is part of a recovered arc: entity {other} is cut for it, and cutting begins there.",
        "Nothing, when that is meant; [+keep-duplicates], or [-recover-arcs], it is cut by itself.");

    public static readonly DiagnosticRule MoreOfTheSame = new("SEQ0014", Severity.Info,
        "{id} was found {count} times in all; only the first {shown} are listed.", "Mend the cause of the first ones and sequence the drawing again; the list of discontinuities is complete.");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
        [DuplicatesRemoved, OpenEnds, SmallGap, ShortSegments, EntryNotFound, EntryWaits, NothingToCut, Branches, ArcRecovered, CircleRecovered, EntryStandsIn, MoreOfTheSame];
}
