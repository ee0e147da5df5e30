namespace Engraver.Core.Diagnostics;

/// <summary>The findings of the DXF reader. The facts of a finding about a record are always its type, its position and a detail.</summary>
public static class DxfRules
{
    public static readonly DiagnosticRule EmptyFile = new("DXF0001", Severity.Error);

    public static readonly DiagnosticRule NotDxf = new("DXF0002", Severity.Error, "found");

    public static readonly DiagnosticRule UnitsAssumed = new("DXF0003", Severity.Warning, "insunits", "measurement", "unit");

    public static readonly DiagnosticRule DwgFile = new("DXF0004", Severity.Error, "version");

    public static readonly DiagnosticRule Truncated = new("DXF0005", Severity.Error, "place");

    public static readonly DiagnosticRule DamagedRecord = new("DXF0006", Severity.Error, "type", "place", "found");

    public static readonly DiagnosticRule BadValue = new("DXF0007", Severity.Error, "type", "place", "value");

    public static readonly DiagnosticRule MissingValue = new("DXF0008", Severity.Error, "type", "place", "code");

    public static readonly DiagnosticRule RepeatedValue = new("DXF0009", Severity.Warning, "type", "place", "code");

    public static readonly DiagnosticRule NoLength = new("DXF0010", Severity.Warning, "type", "place", "why");

    public static readonly DiagnosticRule NegativeRadius = new("DXF0011", Severity.Warning, "type", "place", "radius");

    public static readonly DiagnosticRule TypeNotRead = new("DXF0012", Severity.Warning, "type", "place");

    public static readonly DiagnosticRule TiltedCurve = new("DXF0014", Severity.Warning, "type", "place");

    public static readonly DiagnosticRule MeshLeftOut = new("DXF0016", Severity.Warning, "type", "place");

    public static readonly DiagnosticRule MissingBlock = new("DXF0017", Severity.Error, "type", "place", "name");

    public static readonly DiagnosticRule RecursiveBlock = new("DXF0018", Severity.Error, "type", "place", "name");

    public static readonly DiagnosticRule TooManyCurves = new("DXF0019", Severity.Error, "type", "place", "name");

    public static readonly DiagnosticRule SplineWithoutKnots = new("DXF0021", Severity.Warning, "type", "place", "repair");

    public static readonly DiagnosticRule PolylineWithoutEnd = new("DXF0022", Severity.Warning, "type", "place");

    public static readonly DiagnosticRule PartAlone = new("DXF0023", Severity.Error, "type", "place");

    public static readonly DiagnosticRule WidthIgnored = new("DXF0024", Severity.Info, "type", "place");

    public static readonly DiagnosticRule NoExtrusion = new("DXF0025", Severity.Warning, "type", "place");

    public static readonly DiagnosticRule NothingInserted = new("DXF0026", Severity.Warning, "type", "place", "name");

    public static readonly DiagnosticRule SplineWeights = new("DXF0027", Severity.Warning, "type", "place", "weights");

    public static readonly DiagnosticRule ForeignText = new("DXF0028", Severity.Warning, "encoding");

    public static readonly DiagnosticRule MoreOfTheSame = new("DXF0029", Severity.Info, "id", "count", "shown");

    public static readonly DiagnosticRule VertexCount = new("DXF0030", Severity.Warning, "type", "place", "counts");

    public static readonly DiagnosticRule CutRecord = new("DXF0031", Severity.Error, "type", "place");

    public static readonly DiagnosticRule SectionWithoutEnd = new("DXF0032", Severity.Warning, "name", "place");

    public static readonly DiagnosticRule OutOfRange = new("DXF0033", Severity.Error, "type", "place");

    public static readonly DiagnosticRule SplineUnusable = new("DXF0034", Severity.Error, "type", "place", "points");

    public static readonly DiagnosticRule BlockTwice = new("DXF0035", Severity.Warning, "type", "place", "name");

    public static readonly DiagnosticRule UnknownCodePage = new("DXF0036", Severity.Info, "name");

    public static readonly DiagnosticRule OddNumber = new("DXF0037", Severity.Warning, "type", "place", "value");

    public static readonly DiagnosticRule OutlineUnusable = new("DXF0038", Severity.Warning, "type", "place", "why");

    public static readonly DiagnosticRule TextsLeftOut = new("DXF0039", Severity.Info, "count");

    public static readonly DiagnosticRule OtherFormat = new("DXF0040", Severity.Error, "format");

    public static readonly DiagnosticRule SplineFromFitPoints = new("DXF0041", Severity.Info, "type", "place", "count");

    public static readonly DiagnosticRule OutsideOfSections = new("DXF0042", Severity.Warning, "place");

    public static readonly DiagnosticRule ModelSpaceBlock = new("DXF0043", Severity.Warning, "place", "count");

    public static readonly DiagnosticRule RestUnreadable = new("DXF0044", Severity.Info, "place");

    public static readonly DiagnosticRule RecordMayBeLost = new("DXF0050", Severity.Error, "type", "place", "found");

    public static readonly DiagnosticRule TwoRecords = new("DXF0051", Severity.Error, "type", "place", "code");

    public static readonly DiagnosticRule SectionPassedOver = new("DXF0052", Severity.Error, "name", "count", "place");

    public static readonly DiagnosticRule DamageBesideCurves = new("DXF0053", Severity.Warning, "name", "place", "found");

    public static readonly DiagnosticRule ZeroBytes = new("DXF0054", Severity.Error, "place", "count");

    public static readonly DiagnosticRule ZeroScale = new("DXF0055", Severity.Warning, "type", "place", "group");

    public static readonly DiagnosticRule WeightsTooUnequal = new("DXF0056", Severity.Error, "type", "place", "ratio");

    public static readonly DiagnosticRule MisplacedRecord = new("DXF0057", Severity.Error, "type", "place", "section");

    public static readonly DiagnosticRule NameDamaged = new("DXF0058", Severity.Error, "type", "place", "damage");

    public static readonly DiagnosticRule MoreThanOneTurn = new("DXF0059", Severity.Warning, "type", "place", "span");

    public static readonly DiagnosticRule CurveLost = new("DXF0060", Severity.Error, "type", "place", "lengths");

    public static readonly DiagnosticRule BinaryConverted = new("DXF0061", Severity.Error);

    public static readonly DiagnosticRule AllOnPaper = new("DXF0062", Severity.Warning, "count");

    public static readonly DiagnosticRule Dashed = new("DXF0063", Severity.Warning, "type", "place", "linetype");

    /// <summary>Every rule, by id. DXF0013 (curve not read) and DXF0015 (unequal scale) are retired: such curves are now read.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
    [
        EmptyFile, NotDxf, UnitsAssumed, DwgFile, Truncated, DamagedRecord, BadValue, MissingValue, RepeatedValue, NoLength, NegativeRadius, TypeNotRead,
        TiltedCurve, MeshLeftOut, MissingBlock, RecursiveBlock, TooManyCurves, SplineWithoutKnots, PolylineWithoutEnd, PartAlone,
        WidthIgnored, NoExtrusion, NothingInserted, SplineWeights, ForeignText, MoreOfTheSame, VertexCount, CutRecord, SectionWithoutEnd, OutOfRange, SplineUnusable, BlockTwice, UnknownCodePage,
        OddNumber, OutlineUnusable, TextsLeftOut, OtherFormat, SplineFromFitPoints, OutsideOfSections, ModelSpaceBlock, RestUnreadable,
        RecordMayBeLost, TwoRecords, SectionPassedOver, DamageBesideCurves, ZeroBytes, ZeroScale, WeightsTooUnequal, MisplacedRecord, NameDamaged, MoreThanOneTurn, CurveLost, BinaryConverted, AllOnPaper, Dashed,
    ];
}
