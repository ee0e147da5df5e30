using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing;
using Engraver.Core.Tests.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Offsets;

/// <summary>The closed contours of real drawings.</summary>
public class CorpusOffsetTests
{
    /// <summary>As a fraction of the contour's size.</summary>
    private static readonly double[] s_distances = [1.0 / 20.0, 1.0 / 300.0, 1.0 / 3000.0, 0.4];

    /// <summary>Every drawing in the full run, every eighth in the subset.</summary>
    private static readonly int Every = TestExtent.Cases(perCommit: 16, full: 1, "ENGRAVER_OFFSET_EVERY");

    [CorpusFact]
    public void Every_closed_contour_of_the_corpus_is_offset_to_closed_loops()
    {
        var (contours, wrong) = (0, new List<string>());
        var files = Directory.EnumerateFiles(RepositoryFolder.Corpus!, "*.dxf", SearchOption.AllDirectories).Order(StringComparer.Ordinal).ToArray();
        for (var i = 0; i < files.Length; i += Every)
        {
            foreach (var contour in ClosedOf(files[i]))
            {
                contours++;
                if (FaultOf(contour) is { } fault) wrong.Add($"{Path.GetFileName(files[i])}: {fault}");
            }
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong.Take(20)));
        Assert.True(contours > (TestExtent.IsFull ? 500 : 10), $"only {contours} contours");
    }

    private static IEnumerable<OffsetContour> ClosedOf(string file)
    {
        var drawing = DxfReading.Of(File.ReadAllBytes(file));
        var chained = Sequencer.Chain(ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, new LayerSelection([], []))), drawing, UsualOptions.Sequencing);
        var rows = chained.Segments.ToArray();
        foreach (var contour in chained.Chain.Contours.Where(contour => contour.Closed))
        {
            yield return new OffsetContour([.. contour.Pieces.ToArray().Select(piece => piece.Reversed ? rows[piece.Row].Reversed() : rows[piece.Row])], true);
        }
    }

    /// <summary>Several distances, in and out: closed, not nearer than the distance, and outwards around everything. Contours drawn with gaps or as curves have
    /// their tolerance.</summary>
    private static string? FaultOf(OffsetContour contour)
    {
        var box = BoxOf(contour.Segments);
        var size = Math.Max(box.Width, box.Height);
        if (!(size > 1e-6)) return null;
        foreach (var distance in s_distances)
        {
            foreach (var side in new[] { OffsetSide.In, OffsetSide.Out })
            {
                var result = ContourOffset.Offset([contour], size * distance, side, UsualOptions.Offset);
                if (result.Unresolved.Count > 0) return $"{distance} {side} unresolved at {result.Unresolved[0]}";
                if (result.Loops.Any(loop => !loop.Closed || loop.Segments[^1].End != loop.Segments[0].Start)) return $"{distance} {side} is open";
                if (result.MaxDeviation > 0.012) return $"{distance} {side} deviates by {result.MaxDeviation}";
                if (side == OffsetSide.Out && !result.Loops.Any(loop => !loop.IsHole && BoxOf(loop.Segments).Grown(0.02).Contains(box))) return $"{distance}: nothing goes round it";
            }
        }

        return null;
    }

    private static Bounds2D BoxOf(IEnumerable<Segment> segments) => segments.Aggregate(Bounds2D.Empty, (all, segment) => all.Union(segment.Bounds));
}
