using System.Text;
using Engraver.Benchmarks.Stages;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Benchmarks.Ordering;

/// <summary>Strokes from a seeded generator, and the drawing of them in a random order.</summary>
/// <param name="Name">Kind and number of strokes: <c>nested-500</c>.</param>
internal sealed record OrderInstance(string Name, IReadOnlyList<OrderShape> Shapes)
{
    private const double Tolerance = 1e-4;

    /// <summary>The chained drawing, and the shape of each of its entities.</summary>
    public (ChainedTable Chained, int[] ShapeOf) Chain()
    {
        var (sheet, shapeOf) = (new List<DxfSheetEntity>(), new List<int>());
        int[] order = [.. Enumerable.Range(0, Shapes.Count)];
        new SeededSequence((ulong)Shapes.Count).Shuffle<int>(order);
        foreach (var shape in order)
        {
            foreach (var segment in Shapes[shape].Segments())
            {
                sheet.Add(new DxfSheetEntity(segment, "0", null, 0, 0));
                shapeOf.Add(shape);
            }
        }

        using var bytes = new MemoryStream();
        using (var writer = new StreamWriter(bytes, Encoding.ASCII, leaveOpen: true)) DxfWriter.Write(new DxfSheet([new DxfSheetLayer("0", 7)], sheet), writer);
        var drawing = DxfReader.Read(bytes.ToArray(), Name + ".dxf", new DxfReadOptions(), CancellationToken.None);
        return (Sequencer.Chain(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default)), drawing, Options), [.. shapeOf]);
    }

    public static SequencingOptions Options { get; } = new() { JoinTolerance = Tolerance, DuplicateTolerance = Tolerance / 10.0, KeepDuplicates = true, ToolEnd = default(Point2D), Order = StrokeOrder.Nearest };
}
