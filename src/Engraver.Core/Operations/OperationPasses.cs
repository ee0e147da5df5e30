using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Core.Operations;

/// <summary>The strokes of the operations at the depths of their passes.</summary>
/// <param name="Sequence">Every pass is a stroke; heights are those of the tool.</param>
/// <param name="Strokes">Operation and pass of each stroke.</param>
public sealed record OperationPasses(SequencingResult Sequence, IReadOnlyList<StrokePass> Strokes)
{
    /// <summary>Leads and tabs for which there was not enough room.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];

    /// <summary>Tabs and starts of the operations that have any.</summary>
    public IReadOnlyList<DressedPlaces> Places { get; init; } = [];

    /// <param name="ordered">In the order of the operations.</param>
    /// <param name="drawn">The drawing as contours, for its discontinuities.</param>
    /// <param name="contours">Contours from which leads keep away.</param>
    /// <param name="options">Start of the tool.</param>
    /// <param name="maxErrorMm">Largest distance of the chords of a slope from their arc, above 0.</param>
    public static OperationPasses Of(IReadOnlyList<OrderedOperation> ordered, ChainedTable drawn, IReadOnlyList<Segment> contours, Drawing drawing, SequencingOptions options, double maxErrorMm)
    {
        ArgumentNullException.ThrowIfNull(contours);
        ArgumentNullException.ThrowIfNull(ordered);
        ArgumentNullException.ThrowIfNull(drawn);
        ArgumentNullException.ThrowIfNull(options);
        var (table, cuts, findings) = (new EntityTable(), new List<(OrderedStroke Stroke, int Rows, StrokePass Pass)>(), new List<Diagnostic>());
        var dressed = new List<DressedPlaces>();
        var parts = new PartClearance([.. contours]);
        foreach (var operation in ordered)
        {
            var steps = StrokeDressing.DepthSteps(operation.Shape.Operation).ToList();
            var dressing = StrokeDressing.For(operation, parts, maxErrorMm);
            foreach (var (stroke, pass) in InOrder(operation, steps.Count))
            {
                foreach (var (rows, closed) in dressing?.Append(table, stroke, steps[pass].Before, steps[pass].Depth) ?? [Append(table, operation, operation.Strokes[stroke], steps[pass].Depth)])
                {
                    cuts.Add((operation.Strokes[stroke] with { Closed = closed }, rows, new StrokePass(operation.Shape.Operation, stroke, pass, steps[pass].Depth)));
                }
            }

            if (dressing is null) continue;
            findings.AddRange(dressing.Findings);
            dressed.Add(dressing.Places);
        }

        var places = cuts.Select((cut, index) => (Key: (cut.Pass.Operation.Id, cut.Pass.Stroke, cut.Pass.Pass), index)).DistinctBy(cut => cut.Key).ToDictionary(cut => cut.Key, cut => cut.index);
        var (strokes, curves) = (new StrokeList(table, cuts.Count), new CurveCount(drawing));
        foreach (var (stroke, rows, pass) in cuts) strokes.Add(stroke.Closed, rows, stroke.Inside < 0 ? -1 : places[(pass.Operation.Id, stroke.Inside, pass.Pass)], curves);
        return new OperationPasses(ResultOf(ordered, drawn, table, strokes, options), [.. cuts.Select(cut => cut.Pass)]) { Findings = findings, Places = dressed };
    }

    /// <summary>The strokes and passes in the order of cutting. A hole is drilled in one stroke, pecks included. Repeats with a stop between them are cut one
    /// after the other, each with all strokes.</summary>
    private static IEnumerable<(int Stroke, int Pass)> InOrder(OrderedOperation operation, int passes)
    {
        var (strokes, own) = (operation.Strokes.Count, operation.Shape.Operation);
        if (own.Order == PassOrder.Level) return ByLevel(0, passes);
        var byContour = own.StopsBetween ? own.LastPass + 1 : passes;
        return Enumerable.Range(0, byContour * strokes).Select(step => (step / byContour, step % byContour)).Concat(ByLevel(byContour, passes));

        IEnumerable<(int Stroke, int Pass)> ByLevel(int first, int end) => Enumerable.Range(first * strokes, (end - first) * strokes).Select(step => (step % strokes, step / strokes));
    }

    private static DressedPiece Append(EntityTable table, OrderedOperation operation, OrderedStroke stroke, double depth)
    {
        var before = table.Count;
        if (operation.Shape.Operation.Kind == OperationKind.Drill)
        {
            foreach (var (from, to) in DrillMoves(operation.Shape.Operation, depth)) OperationRows.Append(table, operation.Path, stroke.FirstRow, -from, -to);
        }
        else
        {
            for (var row = stroke.FirstRow; row < stroke.FirstRow + stroke.Rows; row++) OperationRows.Append(table, operation.Path, row, -depth, -depth);
        }

        return new DressedPiece(table.Count - before, stroke.Closed);
    }

    /// <summary>Depths between which the tool moves straight up and down, after it has plunged to the surface.</summary>
    private static IEnumerable<(double From, double To)> DrillMoves(Operation operation, double depth)
    {
        var (top, reached) = (operation.StartDepth, operation.StartDepth);
        var count = operation.Peck is { } peck ? (int)Math.Ceiling((depth - top) / peck * (1.0 - 1e-12)) : 1;
        for (var i = 1; i <= count; i++)
        {
            var next = i == count ? depth : top + ((depth - top) * i / count);
            if (reached > top) yield return (reached, top);
            yield return (top, next);
            reached = next;
        }
    }

    private static SequencingResult ResultOf(IReadOnlyList<OrderedOperation> ordered, ChainedTable drawn, EntityTable table, StrokeList strokes, SequencingOptions options)
    {
        var travel = TravelDistance.Through(options.ToolStart, strokes);
        return new SequencingResult
        {
            Strokes = strokes,
            Discontinuities = new OpenEndList(drawn, options),
            Table = table,
            Segments = strokes.Sum(stroke => stroke.Segments),
            Reversed = ordered.Sum(operation => operation.Reversed),
            DuplicatesRemoved = ordered.Sum(operation => operation.DuplicatesRemoved),
            PathLength = strokes.Sum(stroke => stroke.Length),
            Travel = travel,
            TravelAndBack = travel + (strokes.Count == 0 ? 0.0 : strokes[^1].End.DistanceTo(options.ToolStart)),
            TravelAsDrawn = TravelDistance.AsDrawn(options.ToolStart, drawn.Analysed),
            Diagnostics = [.. ordered.SelectMany(operation => operation.Diagnostics).DistinctBy(finding => (finding.Rule, finding.Source, finding.Sentence))],
        };
    }
}
