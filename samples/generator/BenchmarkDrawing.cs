using Engraver.Benchmarks.Stages;
using Engraver.Samples.Dxf;
using Engraver.Samples.Geometry;

namespace Engraver.Samples;

/// <summary>The drawing that the benchmarks measure, as a file.</summary>
internal static class BenchmarkDrawing
{
    /// <param name="lines">Number of LINE entities.</param>
    /// <param name="shuffled">Whether to put the lines into random order, every other one (by chance) reversed.</param>
    /// <param name="seed">The same seed gives the same drawing.</param>
    public static DxfDocument Draw(int lines, bool shuffled, ulong seed)
    {
        var drawn = SeededPolygons.Lines(lines, shuffled, seed)
            .Select(line => new LineEntity(SeededPolygons.Layers[line.Layer], new Point(line.FromX, line.FromY), new Point(line.ToX, line.ToY)));
        return new DxfDocument(DxfVersion.R2000, DrawingUnit.Millimetres, [.. SeededPolygons.Layers.Select((name, i) => new DxfLayer(name, i + 1))], [.. drawn]);
    }
}
