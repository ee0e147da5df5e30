namespace Engraver.Core.Diagnostics;

/// <summary>Faults of a program that is read back and replayed (lines are lines of the program's file), and of a toolpath that is compared with its drawing.</summary>
public static class VerificationRules
{
    public static readonly DiagnosticRule ProgramEmpty = new("VER0001", Severity.Error,
        "There is no program in the file.", "Post the drawing again.");

    public static readonly DiagnosticRule NoJobLabel = new("VER0002", Severity.Error,
        "The program has no line #JOB, where it would start.", "Give a file that was posted for this controller, or post the drawing again.");

    public static readonly DiagnosticRule ChunksIncomplete = new("VER0003", Severity.Error,
        "Chunk {expected} of {count} should begin here, but the line says '{line}'.", "Give the whole file as it was posted, or post the drawing again.");

    public static readonly DiagnosticRule LineUnusable = new("VER0004", Severity.Error,
        "The controller cannot be sent the line: {reason}.", "Repair the line or post the drawing again.");

    public static readonly DiagnosticRule NotLoaded = new("VER0005", Severity.Error,
        "The controller does not take the program: TC {code} ({text}).", "Post the drawing again; a controller holds 1000 lines and 254 different labels.");

    public static readonly DiagnosticRule LineRefused = new("VER0006", Severity.Error,
        "The program stops at '{line}', which the controller refuses with TC {code} ({text}).", "Repair the line or post the drawing again.");

    public static readonly DiagnosticRule Endless = new("VER0007", Severity.Error,
        "The program did not come to its end: {reason}.", "Look for a loop, a wait for an input or a vector sequence without VE; a feed other than the profile's must be given again ([feed]).");

    public static readonly DiagnosticRule CutBesideDrawing = new("VER0008", Severity.Error,
        "The program cuts {deviation} mm beside the drawing at {x}, {y}; {tolerance} mm are allowed.", "Compare the program with the drawing there.");

    public static readonly DiagnosticRule NotCut = new("VER0009", Severity.Error,
        "The program leaves {length} mm of the drawing uncut, first at {x}, {y}.", "Compare the program with the drawing there; layers and units must be given as they were posted.");

    public static readonly DiagnosticRule ToolpathBeside = new("VER0020", Severity.Error,
        "The toolpath runs {deviation} mm beside the entity at {x}, {y}; {tolerance} mm are allowed.", NotSent);

    public static readonly DiagnosticRule ToolpathMissing = new("VER0021", Severity.Error,
        "The toolpath leaves {length} mm of the entity uncut, first at {x}, {y}.", NotSent);

    public static readonly DiagnosticRule ToolpathExtra = new("VER0022", Severity.Error,
        "The toolpath cuts {length} mm for the entity that are not drawn, first at {x}, {y}.", NotSent);

    /// <summary>The drawing is held against our own path: what is found is never the drawing's fault.</summary>
    private const string NotSent = "Nothing was sent or written, for this is a fault of the program: report it with the drawing, and draw the entity in another way until it is mended.";

    /// <summary>Every rule of this table, in order of id.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
        [ProgramEmpty, NoJobLabel, ChunksIncomplete, LineUnusable, NotLoaded, LineRefused, Endless, CutBesideDrawing, NotCut, ToolpathBeside, ToolpathMissing, ToolpathExtra];
}
