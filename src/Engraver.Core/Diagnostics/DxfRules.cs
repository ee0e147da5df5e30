namespace Engraver.Core.Diagnostics;

/// <summary>The findings of the DXF reader. The facts of a finding about a record are always its type, its position and a detail.</summary>
public static class DxfRules
{
    public static readonly DiagnosticRule EmptyFile = new("DXF0001", Severity.Error,
        "The file is empty.", "Export the drawing again.");

    public static readonly DiagnosticRule NotDxf = new("DXF0002", Severity.Error,
        "The file is no DXF: {found}.", "Save the drawing as DXF (any version, ASCII or binary) and open that.");

    public static readonly DiagnosticRule UnitsAssumed = new("DXF0003", Severity.Warning,
        "The drawing does not say its unit ($INSUNITS is {insunits}, $MEASUREMENT is {measurement}); millimetres were assumed.",
        "Check the size shown; if it is wrong, give [units-mm] or [units-inch].");

    public static readonly DiagnosticRule DwgFile = new("DXF0004", Severity.Error,
        "The file is a DWG ({version}), not a DXF.", "Open it in a CAD program and save it as DXF.");

    public static readonly DiagnosticRule Truncated = new("DXF0005", Severity.Error,
        "The file is incomplete: it ends at {place} without EOF.", "Everything before was read; export or copy the file again and compare.");

    public static readonly DiagnosticRule DamagedRecord = new("DXF0006", Severity.Error,
        "{type} at {place} was left out: '{found}' stands where a group code is due.", "Repair that line or export the drawing again.");

    public static readonly DiagnosticRule BadValue = new("DXF0007", Severity.Error,
        "{type} at {place} was left out: {value}, which is no usable number.", "Repair that value or export the drawing again.");

    public static readonly DiagnosticRule MissingValue = new("DXF0008", Severity.Error,
        "{type} at {place} was left out: it has no group {code}.", "Repair the entity or export the drawing again.");

    public static readonly DiagnosticRule RepeatedValue = new("DXF0009", Severity.Warning,
        "{type} at {place} has group {code} more than once; the first was used.", "Compare the entity with the original drawing.");

    public static readonly DiagnosticRule NoLength = new("DXF0010", Severity.Warning,
        "{type} at {place} has no length{why}; there is nothing to cut.", "Delete it, or draw it as it was meant.");

    public static readonly DiagnosticRule NegativeRadius = new("DXF0011", Severity.Warning,
        "{type} at {place} has the negative radius {radius}; its size was used.", "Compare the entity with the original drawing.");

    public static readonly DiagnosticRule TypeNotRead = new("DXF0012", Severity.Warning,
        "{type} at {place} was left out: this type is not read.", "Explode it to lines and arcs in the CAD program if it has to be cut.");

    public static readonly DiagnosticRule TiltedCurve = new("DXF0014", Severity.Warning,
        "{type} at {place} is tilted against the drawing plane; its plan view is cut.", "Flatten it in the CAD program if its true shape has to be cut.");

    public static readonly DiagnosticRule MeshLeftOut = new("DXF0016", Severity.Warning,
        "{type} at {place} was left out: it is a mesh, not a curve.", "Explode it if its edges have to be cut.");

    public static readonly DiagnosticRule MissingBlock = new("DXF0017", Severity.Error,
        "{type} at {place} was left out: its block '{name}' is not in the file.", "Export the drawing with all its blocks (bind external references).");

    public static readonly DiagnosticRule RecursiveBlock = new("DXF0018", Severity.Error,
        "{type} at {place} was left out: block '{name}' contains itself.", "Repair the block in the CAD program (AUDIT).");

    public static readonly DiagnosticRule TooManyCurves = new("DXF0019", Severity.Error,
        "{type} at {place} was left out: block '{name}' would expand beyond the limit of curves.", "Reduce the array or the nesting.");

    public static readonly DiagnosticRule SplineWithoutKnots = new("DXF0021", Severity.Warning,
        "{type} at {place} has no usable knots for its {pointsAndRepair}.", "Open and save the spline in the CAD program, or explode it to a polyline.");

    public static readonly DiagnosticRule PolylineWithoutEnd = new("DXF0022", Severity.Warning,
        "{type} at {place} has no SEQEND; its vertices were used.", "Compare the polyline with the original drawing.");

    public static readonly DiagnosticRule PartAlone = new("DXF0023", Severity.Warning,
        "{type} at {place} was left out: it belongs to no POLYLINE and no INSERT.", "Compare the place with the original drawing.");

    public static readonly DiagnosticRule WidthIgnored = new("DXF0024", Severity.Info,
        "{type} at {place} has a width; polylines are cut along their centre line.", "Draw the outline if the width has to be cut.");

    public static readonly DiagnosticRule NoExtrusion = new("DXF0025", Severity.Warning,
        "{type} at {place} has an extrusion direction of zero; straight up was used.", "Compare the entity with the original drawing.");

    public static readonly DiagnosticRule NothingInserted = new("DXF0026", Severity.Warning,
        "{type} at {place} was left out: of its block '{name}' no curve could be taken.", "See what is reported of the block's entities.");

    public static readonly DiagnosticRule SplineWeights = new("DXF0027", Severity.Warning,
        "{type} at {place} has {weights}, or weights that are not above zero; all were taken as 1.", "Compare the spline with the original drawing.");

    public static readonly DiagnosticRule ForeignText = new("DXF0028", Severity.Warning,
        "Some names are not valid in the encoding that the file declares ({encoding}); another one was tried.", "Check the layer names.");

    public static readonly DiagnosticRule MoreOfTheSame = new("DXF0029", Severity.Info,
        "{id} was found {count} times in all; only the first {shown} are listed.", "Mend the cause of the first ones and open the drawing again.");

    public static readonly DiagnosticRule VertexCount = new("DXF0030", Severity.Warning,
        "{type} at {place} {counts}; the vertices that stand there were used.", "Compare the polyline with the original drawing.");

    public static readonly DiagnosticRule CutRecord = new("DXF0031", Severity.Error,
        "{type} at {place} was left out: the file ends in the middle of it.", "Export or copy the file again.");

    public static readonly DiagnosticRule SectionWithoutEnd = new("DXF0032", Severity.Warning,
        "Section {name} ends at {place} without ENDSEC.", "Compare the drawing with the original.");

    public static readonly DiagnosticRule OutOfRange = new("DXF0033", Severity.Error,
        "{type} at {place} was left out: its coordinates are too large to be used.", "Check the scale of the INSERT that brings it.");

    public static readonly DiagnosticRule SplineUnusable = new("DXF0034", Severity.Error,
        "{type} at {place} was left out: it has {points}, which makes no curve.", "Draw the spline again, or convert it to a polyline in the CAD program.");

    public static readonly DiagnosticRule BlockTwice = new("DXF0035", Severity.Warning,
        "{type} at {place} defines block '{name}' again; the first definition was used.", "Rename one of the two blocks.");

    public static readonly DiagnosticRule UnknownCodePage = new("DXF0036", Severity.Info,
        "The code page '{name}' is not known; names were read as Windows-1252 or UTF-8.", "Check the layer names.");

    public static readonly DiagnosticRule OddNumber = new("DXF0037", Severity.Warning,
        "{type} at {place} has a number in a foreign spelling: {value}.", "Compare the entity with the original drawing; DXF numbers have a decimal point and an E.");

    public static readonly DiagnosticRule OutlineUnusable = new("DXF0038", Severity.Warning,
        "{type} at {place} was left out: its outline cannot be taken ({why}).", "Explode it in the CAD program, or leave its type out of [cut].");

    public static readonly DiagnosticRule TextsLeftOut = new("DXF0039", Severity.Info,
        "The drawing has more texts than are kept; {count} are, the others are counted only.", "Reduce the arrays of blocks with text if the texts matter.");

    public static readonly DiagnosticRule OtherFormat = new("DXF0040", Severity.Error,
        "The file is {format}, not a DXF.", "Unpack it first when it is packed; otherwise open it in the program that made it and save or export it as DXF.");

    public static readonly DiagnosticRule SplineFromFitPoints = new("DXF0041", Severity.Info,
        "{type} at {place} has no control points; a cubic spline through its {count} fit points was used (chord lengths, its end tangents where it gives any).",
        "Compare its course with the CAD program's.");

    public static readonly DiagnosticRule OutsideOfSections = new("DXF0042", Severity.Warning,
        "At {place} entities stand outside of every section; they were taken as part of the drawing.", "Compare the drawing with the original: an ENDSEC too many, or a lost SECTION.");

    public static readonly DiagnosticRule ModelSpaceBlock = new("DXF0043", Severity.Warning,
        "At {place} the block that is model space has {count} of its own; they were taken as part of the drawing.", "Compare the drawing with the original: they belong in ENTITIES, and may stand there too.");

    public static readonly DiagnosticRule RestUnreadable = new("DXF0044", Severity.Info,
        "The file cannot be read beyond {place}, where the length of a value belies its group code; no entity and no block stands behind it.", "Nothing needs to be done; the drawing is complete.");

    public static readonly DiagnosticRule RecordMayBeLost = new("DXF0050", Severity.Error,
        "Behind {type}, at {place}, stands {found}: a record that began there may be lost.", "Repair that line (above the name of each record stands a line 0), or export the drawing again.");

    public static readonly DiagnosticRule TwoRecords = new("DXF0051", Severity.Error,
        "{type} at {place} was left out: group {code} stands in it twice and a value is the name of a record, as if the 0 between two records were damaged.",
        "Repair the 0 in front of the second record, or export the drawing again.");

    public static readonly DiagnosticRule SectionPassedOver = new("DXF0052", Severity.Error,
        "The section '{name}' was passed over, for no section of a drawing is called so; but it holds {count} of a drawing, the first at {place}.",
        "Repair the name (HEADER, TABLES, BLOCKS, ENTITIES), or export the drawing again.");

    public static readonly DiagnosticRule DamageBesideCurves = new("DXF0053", Severity.Warning,
        "The section {name} is damaged at {place}: '{found}' stands where a group code is due. No curve stands in that section.", "Check units and layer names; export the drawing again if they are wrong.");

    public static readonly DiagnosticRule ZeroBytes = new("DXF0054", Severity.Error,
        "The text of the file is damaged at {place}: {count} of its bytes are zero, as in a file that was written only in part.", "Copy or export the file again.");

    public static readonly DiagnosticRule ZeroScale = new("DXF0055", Severity.Warning,
        "{type} at {place} has the scale 0 in {group}; its block is squeezed to a line or a point.", "Compare the entity with the original drawing; a block as it was drawn has the scale 1.");

    public static readonly DiagnosticRule WeightsTooUnequal = new("DXF0056", Severity.Error,
        "{type} at {place} was left out: its largest weight is {ratio} times its smallest, and beyond a million its course cannot be told.", "Convert the spline to a polyline, or to a spline without weights, in the CAD program.");

    public static readonly DiagnosticRule MisplacedRecord = new("DXF0057", Severity.Error,
        "{type} at {place} was left out: it stands in the section {section}, outside of what belongs there.", "Compare the place with the original drawing: the record in front of it may be lost or damaged.");

    public static readonly DiagnosticRule NameDamaged = new("DXF0058", Severity.Error,
        "'{type}' at {place} was left out: the name of this record is damaged, {damage}.", "Repair the name, or export the drawing again.");

    /// <summary>Every rule, by id. DXF0013 (curve not read) and DXF0015 (unequal scale) are retired: such curves are read now.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } =
    [
        EmptyFile, NotDxf, UnitsAssumed, DwgFile, Truncated, DamagedRecord, BadValue, MissingValue, RepeatedValue, NoLength, NegativeRadius, TypeNotRead,
        TiltedCurve, MeshLeftOut, MissingBlock, RecursiveBlock, TooManyCurves, SplineWithoutKnots, PolylineWithoutEnd, PartAlone,
        WidthIgnored, NoExtrusion, NothingInserted, SplineWeights, ForeignText, MoreOfTheSame, VertexCount, CutRecord, SectionWithoutEnd, OutOfRange, SplineUnusable, BlockTwice, UnknownCodePage,
        OddNumber, OutlineUnusable, TextsLeftOut, OtherFormat, SplineFromFitPoints, OutsideOfSections, ModelSpaceBlock, RestUnreadable,
        RecordMayBeLost, TwoRecords, SectionPassedOver, DamageBesideCurves, ZeroBytes, ZeroScale, WeightsTooUnequal, MisplacedRecord, NameDamaged,
    ];
}
