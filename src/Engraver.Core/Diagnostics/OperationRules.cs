namespace Engraver.Core.Diagnostics;

/// <summary>The findings of operations: their file, what they take of the drawing, and what they make of it. Lengths in the sentences are
/// millimetres.</summary>
public static class OperationRules
{
    public static readonly DiagnosticRule Unreadable = new("OPR0001", Severity.Error, "reason");

    public static readonly DiagnosticRule FieldUnknown = new("OPR0002", Severity.Error, "field", "nearest");

    public static readonly DiagnosticRule ValueInvalid = new("OPR0003", Severity.Error, "field", "value", "allowed");

    public static readonly DiagnosticRule FieldMissing = new("OPR0004", Severity.Error, "field");

    public static readonly DiagnosticRule LayerUnknown = new("OPR0005", Severity.Error, "operation", "layer", "nearest");

    public static readonly DiagnosticRule HandleUnknown = new("OPR0006", Severity.Error, "operation", "handle");

    public static readonly DiagnosticRule CutTwice = new("OPR0007", Severity.Warning, "one", "other", "count");

    public static readonly DiagnosticRule NotTaken = new("OPR0008", Severity.Warning, "count", "length");

    public static readonly DiagnosticRule TakesNothing = new("OPR0009", Severity.Warning, "operation");

    public static readonly DiagnosticRule NoToolAxis = new("OPR0010", Severity.Error, "operation", "field");

    public static readonly DiagnosticRule NoDepth = new("OPR0011", Severity.Error, "operation");

    public static readonly DiagnosticRule SeveralTools = new("OPR0012", Severity.Error, "tools");

    public static readonly DiagnosticRule DeeperThanTool = new("OPR0013", Severity.Error, "operation", "depth", "tool", "limit");

    public static readonly DiagnosticRule SpindleByHand = new("OPR0014", Severity.Info, "operation", "speed");

    public static readonly DiagnosticRule OpenContour = new("OPR0016", Severity.Error, "operation", "x", "y");

    public static readonly DiagnosticRule NotPosted = new("OPR0017", Severity.Error, "target", "reason");

    public static readonly DiagnosticRule NotAsStated = new("OPR0018", Severity.Error, "operation", "what", "x", "y");

    public static readonly DiagnosticRule NotDrilled = new("OPR0019", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule NothingOn = new("OPR0020", Severity.Error, "tool");

    public static readonly DiagnosticRule NoLead = new("OPR0021", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule LeadShortened = new("OPR0022", Severity.Info, "operation", "count", "x", "y");

    public static readonly DiagnosticRule FewerTabs = new("OPR0023", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule NotFilled = new("OPR0024", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule ToolNotChanged = new("OPR0030", Severity.Warning, "journal", "tool");

    public static readonly DiagnosticRule ToolChanged = new("OPR0035", Severity.Warning, "count", "how");

    public static readonly DiagnosticRule PassMissing = new("OPR0036", Severity.Error, "length", "expected");

    public static readonly DiagnosticRule NotInFormat = new("OPR0037", Severity.Error, "target", "field", "operation");

    public static readonly DiagnosticRule LeftOut = new("OPR0038", Severity.Warning, "target", "field", "operation");

    public static readonly DiagnosticRule PassNotCut = new("OPR0039", Severity.Error, "operation", "count");

    public static readonly DiagnosticRule LinetypeUnknown = new("OPR0040", Severity.Error, "operation", "linetype", "nearest");

    public static readonly DiagnosticRule BlockUnknown = new("OPR0041", Severity.Error, "operation", "block", "nearest");

    public static readonly DiagnosticRule InsertsLeftOut = new("OPR0042", Severity.Error, "operation");

    public static readonly DiagnosticRule GapsClosed = new("OPR0043", Severity.Warning, "operation", "linetype", "gap", "diameter");

    public static readonly DiagnosticRule GapsLeft = new("OPR0044", Severity.Info, "operation", "count", "length");

    public static readonly DiagnosticRule ShapesNotCut = new("OPR0045", Severity.Info, "operation", "linetype");

    public static readonly DiagnosticRule NoDashes = new("OPR0046", Severity.Warning, "operation");

    public static readonly DiagnosticRule HatchesNotRead = new("OPR0047", Severity.Error, "operation");

    public static readonly DiagnosticRule OtherOutputs = new("OPR0048", Severity.Error, "operation", "count");

    public static readonly DiagnosticRule StartUnused = new("OPR0050", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule NoCorner = new("OPR0051", Severity.Info, "operation", "count", "x", "y");

    public static readonly DiagnosticRule TabUnplaced = new("OPR0052", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule OvercutShortened = new("OPR0053", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule NoRamp = new("OPR0054", Severity.Warning, "operation", "count", "x", "y");

    public static readonly DiagnosticRule NoHelix = new("OPR0055", Severity.Warning, "operation", "count", "x", "y");

    /// <summary>A program that cannot stop between repeats is written as several.</summary>
    public static readonly DiagnosticRule SeveralPrograms = new("OPR0056", Severity.Error, "operation", "count");

    public static readonly DiagnosticRule WidthNotCut = new("OPR0060", Severity.Error, "operation", "width", "count", "tool", "least", "most");

    public static readonly DiagnosticRule WidthVaries = new("OPR0061", Severity.Error, "operation", "count");

    public static readonly DiagnosticRule BeamOnAxis = new("OPR0062", Severity.Error, "operation", "field");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
    [
        Unreadable, FieldUnknown, ValueInvalid, FieldMissing, LayerUnknown, HandleUnknown, CutTwice, NotTaken, TakesNothing, NoToolAxis, NoDepth, SeveralTools, DeeperThanTool,
        SpindleByHand, OpenContour, NotPosted, NotAsStated, NotDrilled, NothingOn, NoLead, LeadShortened, FewerTabs, NotFilled, ToolNotChanged, ToolChanged, PassMissing,
        NotInFormat, LeftOut, PassNotCut, LinetypeUnknown, BlockUnknown, InsertsLeftOut, GapsClosed, GapsLeft, ShapesNotCut, NoDashes, HatchesNotRead, OtherOutputs,
        StartUnused, NoCorner, TabUnplaced, OvercutShortened, NoRamp, NoHelix, SeveralPrograms, WidthNotCut, WidthVaries, BeamOnAxis,
    ];
}
