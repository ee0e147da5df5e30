using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A drawing as read: every curve of model space after block expansion, in drawing units, as columns. Immutable once built.</summary>
public sealed record Drawing(
    string FileName,
    long Bytes,
    string DxfVersion,
    string Encoding,
    LengthUnit Unit,
    IReadOnlyList<Layer> Layers,
    GrowingColumn<DrawingEntity> Entities,
    GrowingColumn<DrawingPart> Parts,
    ReadBalance Balance,
    IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>The largest coordinate, drawing units. A larger one could overflow when squared, and work pieces are far smaller.</summary>
    public const double LargestCoordinate = 1e100;

    /// <summary>Side column of the parts that are ellipses or splines: the exact curves, drawing units.</summary>
    public IReadOnlyList<RationalCurve> Curves { get; init; } = [];

    /// <summary>Every TEXT, MTEXT and ATTRIB with its content and position, blocks expanded (the first million).</summary>
    public IReadOnlyList<PlacedText> Texts { get; init; } = [];

    /// <summary>The text styles in file order; none for a file without a STYLE table.</summary>
    public IReadOnlyList<TextStyle> Styles { get; init; } = [];

    /// <summary>Every POINT, blocks expanded (the first million).</summary>
    public IReadOnlyList<PlacedPoint> Points { get; init; } = [];

    /// <summary>The linetypes, those of <see cref="Linetype.Standard"/> first.</summary>
    public IReadOnlyList<Linetype> Linetypes { get; init; } = Linetype.Standard;

    /// <summary>$LTSCALE: scale of the patterns of all linetypes.</summary>
    public double LinetypeScale { get; init; } = 1.0;

    /// <summary>Lineweight where "default" is stated, hundredths of a millimetre.</summary>
    public int DefaultLineweight { get; init; } = Lineweight.UsualDefault;

    /// <summary>The different line styles of the entities, <see cref="LineStyle.ByLayer"/> first.</summary>
    public IReadOnlyList<LineStyle> LineStyles { get; init; } = [LineStyle.ByLayer];

    /// <summary>Names of the blocks.</summary>
    public IReadOnlyList<string> Blocks { get; init; } = [];

    /// <summary>The different blocks within blocks that are inserted, <see cref="BlockPath.None"/> first.</summary>
    public IReadOnlyList<BlockPath> BlockPaths { get; init; } = [BlockPath.None];

    /// <summary>Every copy of every block, in drawing order.</summary>
    public IReadOnlyList<PlacedInsert> Inserts { get; init; } = [];

    /// <summary>False when there were so many inserts that those without curves were left out.</summary>
    public bool HasAllInserts { get; init; } = true;

    /// <summary>Number of the file's points that were kept, whatever edits have done to them since.</summary>
    public int PointsRead { get; init; }

    /// <summary>Entities other than curves and texts that are visible when their layer is, blocks expanded.</summary>
    public IReadOnlyList<ConstructionCount> Construction { get; init; } = [];

    /// <summary>Construction that was read as curves, at the operator's request.</summary>
    public CutChoice Cut { get; init; }

    /// <summary>Where it is compared with its file. Its coordinates are placed ones.</summary>
    public DrawingPlacement Placement { get; init; } = DrawingPlacement.None;

    /// <summary>The map by which <see cref="Placement"/> placed it, drawing units.</summary>
    public Transform2D PlacementMap { get; init; } = Transform2D.Identity;

    /// <summary>Where a place of the file is on the placed drawing; millimetres.</summary>
    public Point2D Placed(Point2D place) => PlacementMap == Transform2D.Identity ? place : Scale.ToMillimetres(PlacementMap.Apply(Scale.ToDrawing(place)));

    /// <summary>The place in the file of a place of the placed drawing; millimetres.</summary>
    public Point2D Unplaced(Point2D place) => PlacementMap == Transform2D.Identity ? place : Scale.ToMillimetres(PlacementMap.Inverse().Apply(Scale.ToDrawing(place)));

    /// <summary>Construction whose outlines were read as areas for operations; it is not cut otherwise.</summary>
    public CutChoice Areas { get; init; }

    /// <summary>Created here and not yet in a file: <see cref="FileName"/> is only its name.</summary>
    public bool IsNew { get; init; }

    /// <summary>Converts between its unit and millimetres.</summary>
    public DrawingScale Scale => new(Unit.MillimetresPerUnit);

    /// <summary>True when a diagnostic has severity error (exit code 1; a job does not start without consent).</summary>
    public bool HasErrors => Diagnostics.Any(d => d.Severity == Severity.Error);

    /// <summary>A drawing from which nothing could be read, with the reason.</summary>
    public static Drawing Unusable(string fileName, long bytes, Diagnostic why) => Bare(fileName, LengthUnit.AssumedMillimetres) with { Bytes = bytes, Diagnostics = [why] };

    /// <summary>A new drawing with nothing in it.</summary>
    /// <param name="name">Its name until it is saved.</param>
    public static Drawing Empty(string name, LengthUnit unit, Layer layer) => Bare(name, unit) with { Layers = [layer], IsNew = true };

    /// <summary>True for a coordinate that is not above the largest; false for NaN.</summary>
    public static bool Holds(double coordinate) => Math.Abs(coordinate) <= LargestCoordinate;

    /// <summary>True for a box whose corners are not above the largest coordinate.</summary>
    public static bool Holds(Bounds2D box) => Holds(box.MinX) && Holds(box.MaxX) && Holds(box.MinY) && Holds(box.MaxY);

    /// <summary>The highest handle of an entity or a text; 0 when none has one.</summary>
    public ulong HighestHandle()
    {
        var highest = Texts.Count == 0 ? 0UL : Texts.Max(text => text.Handle);
        for (var index = 0; index < Entities.Count; index++) highest = Math.Max(highest, Entities[index].Handle);
        return highest;
    }

    /// <summary>The same drawing; its columns are those of an earlier reading of the file where both are equal, so that a drawing that is opened again does not
    /// use more memory.</summary>
    public Drawing SharingColumnsOf(Drawing earlier)
    {
        ArgumentNullException.ThrowIfNull(earlier);
        var isSame = earlier.FileName == FileName && earlier.Bytes == Bytes && Entities.HasRowsOf(earlier.Entities, DrawingEntity.AreSame) && Parts.HasRowsOf(earlier.Parts, DrawingPart.AreSame);
        return isSame ? this with { Entities = earlier.Entities, Parts = earlier.Parts } : this;
    }

    public SourceRef SourceOf(int entityIndex)
    {
        ref var entity = ref Entities[entityIndex];
        return new SourceRef(entity.SourceLine, entity.Handle == 0 ? null : entity.Handle.ToString("X", CultureInfo.InvariantCulture));
    }

    /// <summary>The effective colour of an entity, "by layer" resolved: an index or a true colour.</summary>
    public DrawingColour ColourOf(int entityIndex)
    {
        ref var entity = ref Entities[entityIndex];
        return entity.Colour.Resolved(Layers[entity.Layer].Colour, DrawingColour.Foreground);
    }

    /// <summary>The effective linetype of an entity, "by layer" resolved: index into <see cref="Linetypes"/>.</summary>
    public int LinetypeOf(int entityIndex)
    {
        ref var entity = ref Entities[entityIndex];
        return Effective(LineStyles[entity.LineStyle].Linetype, entity.Layer);
    }

    /// <summary>Width of the line of an entity, millimetres: of a polyline its constant width, if it has one, otherwise its effective lineweight. NaN for a
    /// width that varies.</summary>
    public double LineWidthOf(int entityIndex)
    {
        ref var entity = ref Entities[entityIndex];
        var style = LineStyles[entity.LineStyle];
        if (style.Width != 0.0) return Scale.ToMillimetres(style.Width);
        var weight = style.Lineweight == Lineweight.ByLayer ? Layers[entity.Layer].Lineweight : style.Lineweight;
        return (weight < 0 ? DefaultLineweight : weight) / 100.0; // outside blocks there is no insert
    }

    /// <summary>The effective linetype of a point.</summary>
    public int LinetypeOf(in PlacedPoint point) => Effective(point.Linetype, point.Layer);

    private int Effective(int linetype, int layer) => linetype switch
    {
        Linetype.ByLayer => Layers[layer].Linetype,
        Linetype.ByBlock => Linetype.Continuous, // outside blocks there is no insert
        _ => linetype,
    };

    /// <summary>True for an outline that only operations may take as an area.</summary>
    public bool IsAreaOnly(CurveType type) => Areas != CutChoice.None && ((type == CurveType.Hatch && Areas.HasFlag(CutChoice.Hatch)) || (type is CurveType.Solid or CurveType.Trace or CurveType.Face3D && Areas.HasFlag(CutChoice.Solid)));

    /// <summary>Index into <see cref="BlockPaths"/> of the block from which an entity comes; 0 for none.</summary>
    public int BlockPathOf(int entityIndex)
    {
        var insert = Entities[entityIndex].Insert;
        return insert > 0 ? Inserts[insert - 1].Path : -insert;
    }

    /// <summary>A part in plan (z dropped), drawing units.</summary>
    public Segment SegmentOf(in DrawingPart part) => part.IsFreeCurve ? Segment.FromCurve(Curves[part.CurveIndex]) : part.InPlan();

    /// <summary>Length of a part along the curve in space, drawing units.</summary>
    public double SpaceLengthOf(in DrawingPart part) => part.IsFreeCurve ? Curves[part.CurveIndex].SpaceLength : part.SpaceLength;

    private static Drawing Bare(string fileName, LengthUnit unit)
    {
        var nothing = new Dictionary<string, int>();
        return new Drawing(fileName, 0, "", "ascii", unit, [], new GrowingColumn<DrawingEntity>(), new GrowingColumn<DrawingPart>(), new ReadBalance(nothing, 0, 0, [], [], nothing, 0), []);
    }

    /// <summary>The first curve with a handle (hexadecimal, any case, leading zeros allowed); null when there is none.</summary>
    public int? IndexOfHandle(string handle)
    {
        if (!ulong.TryParse(handle, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var number) || number == 0) return null;
        for (var i = 0; i < Entities.Count; i++)
        {
            if (Entities[i].Handle == number) return i;
        }

        return null;
    }
}
