using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Text;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>Counts visible construction by type and layer; in blocks once for every copy, up to the limit. Texts are not counted here: they are kept
/// (<see cref="TextExpander"/>).</summary>
internal sealed class ConstructionTally(IReadOnlyDictionary<int, BlockDefinition> blocks, LayerTable layers, BlockPathTable paths, CancellationToken cancellation) : IBlockVisitor
{
    /// <summary>Maximum number of counts and inserts that are visited. In a larger drawing the reported numbers are too small, but never zero.</summary>
    private const int MaxSteps = 1_000_000;

    private readonly Dictionary<(string Type, int Layer), (long Count, SourceRef First)> _counts = [];
    private BlockWalk? _walk;
    private long _steps;

    /// <summary>True for a record that is drawn and counted here.</summary>
    /// <param name="inBlock">True in a block, where an ATTDEF is not counted: it is a template, and the ATTRIB of each insert is visible; a constant one is a
    /// text.</param>
    public static bool Counts(EntityRecord record, bool inBlock) =>
        !record.Invisible && record.Kind is not (RecordKind.Text or RecordKind.Attribute or RecordKind.Insert) && record.Type != "VIEWPORT" && !(inBlock && record.Kind == RecordKind.AttributeDefinition);

    public static SourceRef SourceOf(EntityRecord record) => new(record.Line, record.Handle == 0 ? null : record.Handle.ToString("X", System.Globalization.CultureInfo.InvariantCulture));

    public void Add(EntityRecord record) => Add(record.Type, record.Layer, 1, SourceOf(record));

    /// <summary>Counts the content of an insert of model space. The weight of its block is known.</summary>
    public void Expand(in BlockInsert insert)
    {
        if (!blocks.TryGetValue(insert.Block, out var block) || block.Weight is not { ConstructionSteps: > 0 } weight) return;
        _steps = BlockWeight.Sum(_steps, BlockWeight.Times(insert.Copies, weight.ConstructionSteps));
        if (_steps <= MaxSteps) (_walk ??= new BlockWalk(blocks, layers, paths, this, cancellation)).Through(insert, block);
        else Count(block, InsertStyle.FromModelSpace(insert, paths) with { Hidden = insert.Invisible || layers.IsFrozen(insert.Layer) });
    }

    public IReadOnlyList<ConstructionCount> ToCounts() =>
        [.. _counts.Select(entry => new ConstructionCount(entry.Key.Type, entry.Key.Layer, (int)Math.Min(entry.Value.Count, int.MaxValue), entry.Value.First))];

    public bool ShouldVisit(BlockWeight weight) => weight.ConstructionSteps > 0;

    public int Enter(BlockDefinition block, in Placement at, in InsertStyle style, int around)
    {
        Count(block, style);
        return 0;
    }

    public void Curves(int first, int end, in Placement at, in InsertStyle style)
    {
    }

    private void Count(BlockDefinition block, in InsertStyle style)
    {
        if (style.Hidden) return;
        foreach (var (key, found) in block.Construction) Add(key.Type, style.LayerOf(key.Layer, layers), found.Count, found.First);
    }

    private void Add(string type, int layer, long count, SourceRef first)
    {
        var known = _counts.GetValueOrDefault((type, layer), (0, first));
        _counts[(type, layer)] = (BlockWeight.Sum(known.Item1, count), known.Item2);
    }
}
