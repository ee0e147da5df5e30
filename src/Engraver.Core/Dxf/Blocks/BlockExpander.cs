using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Adds the curves of a block to the drawing, once for every copy. The cost is known before the first curve is placed.</summary>
internal sealed class BlockExpander(
    IReadOnlyDictionary<int, BlockDefinition> blocks,
    NameTable blockNames,
    CurveColumns blockCurves,
    CurveColumns drawing,
    LayerTable layers,
    LineStyleTable styles,
    BlockPathTable paths,
    ReadTally balance,
    int maxSteps,
    CancellationToken cancellation) : IBlockVisitor
{
    /// <summary>Maximum number of inserts when those without curves are visited too.</summary>
    private const int MaxInserts = 1_000_000;

    private readonly List<PlacedInsert> _inserts = [];
    private readonly BlockWeights _scale = new(blocks);
    private readonly HashSet<BlockDefinition> _reported = [];
    private readonly HashSet<int> _lostCurves = [];
    private readonly List<DrawingPart> _parts = [];
    private readonly List<RationalCurve> _curves = [];
    private readonly HashSet<int> _tilted = [];
    private readonly Dictionary<(int Path, int Around, int Number, Vector3D Position), int> _restored = [];
    private BlockWalk? _walk;
    private long _steps;
    private bool _visitsAll;

    /// <summary>Every copy of a block so far.</summary>
    public IReadOnlyList<PlacedInsert> Inserts => _inserts;

    /// <summary>True after inserts without curves were left out.</summary>
    public bool LeftOut { get; private set; }

    /// <summary>Expands an insert of model space. Returns the finding when nothing, or not everything, was drawn; otherwise null.</summary>
    public RecordIssue? Expand(in BlockInsert insert)
    {
        var name = blockNames[insert.Block];
        if (!blocks.TryGetValue(insert.Block, out var block)) return insert.Finding(DxfRules.MissingBlock, name);
        var weight = _scale.Weigh(block);
        var steps = BlockWeight.Times(insert.Copies, weight.Steps);
        if (weight.Curves > 0 && _steps + steps > maxSteps) return insert.Finding(DxfRules.TooManyCurves, name);
        Report(block);
        balance.AddAnnotations(weight.Annotations, insert.Copies);
        _visitsAll = BlockWeight.Sum(_inserts.Count, BlockWeight.Times(insert.Copies, weight.Inserts + 1)) <= MaxInserts;
        LeftOut |= !_visitsAll;
        if (weight.Curves > 0) _steps += steps;
        if (weight.Curves > 0 || _visitsAll) (_walk ??= new BlockWalk(blocks, layers, paths, this, cancellation)).Through(insert, block);

        return weight.HasUnfollowedInserts || weight.Curves > 0 ? insert.Finding(DxfRules.NothingInserted, name) : null;
    }

    /// <summary>Reports the findings of a block and of all blocks nested in it, once.</summary>
    private void Report(BlockDefinition first)
    {
        var open = new Stack<BlockDefinition>([first]);
        while (open.TryPop(out var block))
        {
            if (!_reported.Add(block)) continue;
            foreach (var issue in block.Issues.Where(issue => !issue.ConcernsMore)) balance.AddInBlock(issue); // the others were reported when they were read
            foreach (var nested in block.Inserts)
            {
                if (nested.Obstacle is null) open.Push(blocks[nested.Insert.Block]);
                else balance.AddInBlock(nested.Insert.Finding(nested.Obstacle, blockNames[nested.Insert.Block]));
            }
        }
    }

    public bool ShouldVisit(BlockWeight weight) => weight.Curves > 0 || _visitsAll;

    public int Enter(BlockDefinition block, in Placement at, in InsertStyle style, int around)
    {
        _inserts.Add(new PlacedInsert(style.Path, around, at.Apply(block.BasePoint), style.Layer, style.Hidden));
        return _inserts.Count;
    }

    public void Curves(int first, int end, in Placement at, in InsertStyle style)
    {
        for (var curve = first; curve < end; curve++) PlaceCurve(curve, at, style);
    }

    /// <summary>The number of the insert of a curve that was written one by one; 0 for none.</summary>
    public int Restored(EntityRecord record)
    {
        if (record.Own is null) return 0;
        var (path, number) = (0, 0);
        foreach (var (block, written, position) in RestoredInserts.Of(record))
        {
            path = paths.Inside(path, blockNames.IdOf(block));
            var key = (path, number, written, position);
            if (!_restored.TryGetValue(key, out var known))
            {
                _inserts.Add(new PlacedInsert(path, number, position, record.Layer, Hidden: false));
                _restored[key] = known = _inserts.Count;
            }

            number = known;
        }

        return number;
    }

    private void PlaceCurve(int index, in Placement at, in InsertStyle style)
    {
        var entity = blockCurves.Entities[index];
        _parts.Clear();
        _curves.Clear();
        for (var i = entity.FirstPart; i < entity.FirstPart + entity.PartCount; i++)
        {
            var outcome = PlacedPart.Try(blockCurves.Parts[i], blockCurves.Curves, at, _curves, out var part);
            if (outcome != PlacementOutcome.Exact) ReportOnce(index, outcome);
            if (outcome == PlacementOutcome.OutOfRange) return;
            if (entity.Type == CurveType.Line || !IsPoint(part)) _parts.Add(part);
        }

        entity.Layer = style.LayerOf(entity.Layer, layers);
        entity.Colour = style.ColourOf(entity.Colour, entity.Layer, layers);
        if (entity.LineStyle != 0) entity.LineStyle = styles.Resolved(entity.LineStyle, style.LinetypeOf(Linetype.ByBlock, entity.Layer, layers), style.LineweightOf(Lineweight.ByBlock, entity.Layer, layers), at);
        entity.Insert = style.Insert;
        entity.Hidden |= style.Hidden;
        drawing.Add(entity, System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_parts), _curves);
    }

    /// <summary>True for a part without length; a scale of zero makes some.</summary>
    private bool IsPoint(in DrawingPart part) => part.IsFreeCurve ? IsPoint(_curves[part.CurveIndex]) : part.Kind == SegmentKind.Line ? part.A == part.D && part.B == part.E && part.C == part.F : part.D == 0.0;

    private static bool IsPoint(RationalCurve curve)
    {
        foreach (var span in curve.Spans)
        {
            if (!span.IsPoint) return false;
        }

        return true;
    }

    /// <summary>Reports a block's curve once, even if it is placed many times.</summary>
    private void ReportOnce(int index, PlacementOutcome outcome)
    {
        var refused = outcome == PlacementOutcome.OutOfRange;
        if (!(refused ? _lostCurves : _tilted).Add(index)) return;
        ref var entity = ref blockCurves.Entities[index];
        balance.AddInBlock(new RecordIssue(refused ? DxfRules.OutOfRange : DxfRules.TiltedCurve, entity.Type.ToDxfName(), entity.Handle, entity.SourceLine, "", refused));
    }
}
