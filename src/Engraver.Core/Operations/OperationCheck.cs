using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Operations;

/// <summary>Compares the strokes of each operation with what the operation states, before anything is sent or written: every pass cuts the whole shape, at the
/// stated depths, and a profile runs in the stated direction. Shares no method with ordering and passes; the shape itself is compared with the drawing by
/// <see cref="Kerf.KerfCheck"/> and by the area that a pocket sweeps.</summary>
public static class OperationCheck
{
    /// <summary>Rounding of depths, millimetres.</summary>
    private const double DepthRounding = 1e-9;

    private const double LengthRounding = 1e-6;

    /// <param name="shapes">The shapes in the order of the operations.</param>
    /// <param name="contours">Contours from which leads keep away.</param>
    /// <param name="toolpath">The path of the whole job.</param>
    /// <param name="strokes">Operation and pass of each of its strokes.</param>
    /// <returns>Empty when the path is as stated.</returns>
    public static IReadOnlyList<Diagnostic> Findings(IReadOnlyList<ShapedOperation> shapes, IReadOnlyList<Segment> contours, Toolpath toolpath, IReadOnlyList<StrokePass> strokes, ToolpathTolerances tolerances, Func<int, SourceRef> sourceOf)
    {
        ArgumentNullException.ThrowIfNull(shapes);
        ArgumentNullException.ThrowIfNull(toolpath);
        ArgumentNullException.ThrowIfNull(strokes);
        var findings = new List<Diagnostic>();
        var leads = new LeadCheck(contours);
        var own = toolpath.Strokes.Zip(strokes).ToLookup(pair => pair.Second.Operation.Id, pair => (Stroke: pair.First, Pass: pair.Second));
        foreach (var shape in shapes)
        {
            var passes = own[shape.Operation.Id].GroupBy(stroke => stroke.Pass.Pass, stroke => (stroke.Stroke, Index: stroke.Pass.Stroke)).OrderBy(pass => pass.Key).Select(pass => pass.ToList()).ToList();
            if (passes.SelectMany(pass => pass).Select(stroke => stroke.Stroke).FirstOrDefault(stroke => (stroke.PierceSeconds, stroke.DwellSeconds) != (shape.Operation.PierceSeconds, shape.Operation.DwellSeconds)) is { } unlike) findings.Add(NotAsStated(shape, "wait", unlike.Start));
            findings.AddRange(shape.Operation.Kind == OperationKind.Drill ? DrillFindings(shape, [.. passes.Select(pass => pass.ConvertAll(stroke => stroke.Stroke))], tolerances) : PassFindings(shape, leads, passes, tolerances, sourceOf));
        }

        return findings;
    }

    private static IEnumerable<Diagnostic> PassFindings(ShapedOperation shape, LeadCheck leads, List<List<(ToolpathStroke Stroke, int Index)>> passes, ToolpathTolerances tolerances, Func<int, SourceRef> sourceOf)
    {
        if (shape.Path.Count == 0) yield break;
        List<double> levels = [-shape.Operation.StartDepth, .. passes.Select(pass => LevelOf(pass[0].Stroke))];
        if (DepthFault(shape.Operation, [.. levels.Skip(1).Select(level => -level)]) is { } fault) yield return NotAsStated(shape, fault, passes.Count > 0 ? passes[0][0].Stroke.Start : default);
        List<double> falls = [.. levels.Zip(levels.Skip(1), (before, level) => before - level)];
        var (tabs, descents) = (new TabCheck(shape), new DescentCheck(shape.Operation, tolerances.MaxError));
        for (var pass = 0; pass < passes.Count; pass++)
        {
            var (before, level) = (levels[pass], levels[pass + 1]);
            var contours = new List<ToolpathStroke>();
            foreach (var pieces in passes[pass].GroupBy(stroke => stroke.Index, stroke => stroke.Stroke).Select(group => group.ToList()))
            {
                var contour = new StrokeContour(shape, pieces);
                if (pieces.SelectMany(piece => piece.Moves).Any(move => move.Role == StrokeRole.Cut && (move.StartZ != level || move.EndZ != level)) || pieces[^1].Moves[^1] is { Role: StrokeRole.Lead } last && (last.StartZ != level || last.EndZ != level)) yield return NotAsStated(shape, "depth", pieces[0].Start);
                if (contour.Stroke.Moves.Count == 0) continue;
                contours.Add(contour.Stroke);
                if (tabs.IsFault(pieces, contour, level, falls)) yield return NotAsStated(shape, "tab", pieces[0].Start);
                if (descents.IsFault(pieces[0], contour.Stroke.Moves, before, level)) yield return NotAsStated(shape, "ramp", pieces[0].Start);
                if (contour.HasOvercutFault(shape.Operation.Overcut)) yield return NotAsStated(shape, "overcut", pieces[0].Start);
                if (leads.Fault(pieces.SelectMany(piece => piece.Moves), shape.Operation.HelixRadius is not null, (shape.Part.Tool.Diameter / 2.0) + shape.Operation.Stock, tolerances.MaxError) is { } place) yield return NotAsStated(shape, "lead", place);
            }

            foreach (var stroke in contours.Where(stroke => DirectionFault(shape.Operation, stroke, contours))) yield return NotAsStated(shape, "direction", stroke.Start);
            foreach (var finding in ToolpathCheck.Findings(shape.Path, new Toolpath(default, contours), tolerances, sourceOf)) yield return finding;
        }
    }

    /// <summary>Height of the first move that cuts the contour.</summary>
    private static double LevelOf(ToolpathStroke stroke) => stroke.Moves.FirstOrDefault(move => move.Role == StrokeRole.Cut, stroke.Moves[0]).StartZ;

    /// <summary>The fault of a list of depths; null when they are those of the operation: equal steps to the depth that is left for the last pass, as few as
    /// the depth of a pass allows, and then the depth itself as often as it is repeated.</summary>
    private static string? DepthFault(Operation operation, List<double> depths)
    {
        var (final, repeated) = (operation.Depth ?? 0.0, operation.Finish > 0.0 ? operation.Repeats : operation.Repeats - 1);
        var count = depths.Count - repeated;
        if (count < 1 || depths.Skip(count).Any(depth => !Is(depth, final))) return "passes";
        var (whole, step) = (final - operation.Finish - operation.StartDepth, operation.DepthPerPass ?? double.PositiveInfinity);
        if (operation.Depth is null) return depths.All(depth => depth == 0.0) ? null : "depth";
        if (whole / count > step + DepthRounding || (count > 1 && whole / (count - 1) <= step - DepthRounding)) return "passes";
        for (var pass = 0; pass < count; pass++)
        {
            var before = pass == 0 ? operation.StartDepth : depths[pass - 1];
            if (!Is(depths[pass] - before, whole / count)) return "depth";
        }

        return null;

        static bool Is(double depth, double wanted) => Math.Abs(depth - wanted) <= DepthRounding;
    }

    /// <summary>True when a closed stroke of a profile has its wall on the other side than stated: by its turns, and by the strokes around it.</summary>
    private static bool DirectionFault(Operation operation, ToolpathStroke stroke, List<ToolpathStroke> pass)
    {
        if (operation is not { Kind: OperationKind.Profile, Direction: not CutDirection.Any, Side: ProfileSide.Nesting or ProfileSide.Outside or ProfileSide.Inside }) return false;
        if (!stroke.Start.IsNear(stroke.End, LengthRounding)) return false;
        var around = pass.Count(other => other.Moves[0].Segment != stroke.Moves[0].Segment && Turns(other, stroke.Start) != 0);
        var isOutside = operation.Side == ProfileSide.Outside || (operation.Side == ProfileSide.Nesting && around % 2 == 0);
        var isClockwise = Total(stroke) < 0.0;
        return isClockwise != (isOutside == (operation.Direction == CutDirection.Climb));
    }

    /// <summary>Sum of the turns of the tangent, degrees: 360 counter-clockwise, -360 clockwise.</summary>
    private static double Total(ToolpathStroke stroke)
    {
        var sum = 0.0;
        for (var i = 0; i < stroke.Moves.Count; i++)
        {
            var (move, next) = (stroke.Moves[i].Segment, stroke.Moves[(i + 1) % stroke.Moves.Count].Segment);
            if (move.Kind is SegmentKind.Arc or SegmentKind.Circle) sum += move.Arc.Sweep.Degrees;
            sum += move.EndTangent.TurnTo(next.StartTangent).Degrees;
        }

        return sum;
    }

    /// <summary>Number of turns of a stroke around a place.</summary>
    private static int Turns(ToolpathStroke stroke, Point2D place)
    {
        const int chords = 32;
        var sum = 0.0;
        foreach (var segment in stroke.Moves.Select(move => move.Segment))
        {
            var count = segment.Kind == SegmentKind.Line ? 1 : chords;
            for (var i = 0; i < count; i++) sum += (segment.PointAt((double)i / count) - place).TurnTo(segment.PointAt((i + 1.0) / count) - place).Degrees;
        }

        return (int)Math.Round(sum / 360.0);
    }

    /// <summary>Each hole once, straight down to its depth.</summary>
    private static IEnumerable<Diagnostic> DrillFindings(ShapedOperation shape, List<List<ToolpathStroke>> passes, ToolpathTolerances tolerances)
    {
        foreach (var place in WrongPlaces(shape, tolerances.MaxError)) yield return NotAsStated(shape, "hole", place);
        var wanted = Enumerable.Range(0, shape.Path.Count).Select(row => shape.Path[row].StartPoint).ToHashSet();
        foreach (var pass in passes)
        {
            var left = new HashSet<Point2D>(wanted);
            foreach (var hole in pass)
            {
                if (!left.Remove(hole.Start)) yield return NotAsStated(shape, "hole", hole.Start);
                if (hole.Moves.Any(move => move.Segment.Start != hole.Start || move.Segment.End != hole.Start)) yield return NotAsStated(shape, "hole", hole.Start);
                if (Math.Abs(hole.Moves.Min(move => Math.Min(move.StartZ, move.EndZ)) + shape.Operation.Depth!.Value) > DepthRounding) yield return NotAsStated(shape, "depth", hole.Start);
            }

            foreach (var missing in left) yield return NotAsStated(shape, "hole", missing);
        }

        if (wanted.Count > 0 && passes.Count != shape.Operation.Repeats) yield return NotAsStated(shape, "passes", default);
    }

    /// <summary>Circles, points and insertion points without a hole, and holes without one of these or nearer to each other than the tolerance.</summary>
    private static IEnumerable<Point2D> WrongPlaces(ShapedOperation shape, double tolerance)
    {
        var (table, most) = (shape.Part.Table, shape.Operation.MaxDiameter ?? double.PositiveInfinity);
        Point2D[] drawn =
        [
            .. Enumerable.Range(0, table.Count).Select(row => table[row].ToSegment()).Where(segment => segment is { IsClosed: true, Kind: SegmentKind.Circle } && segment.Bounds.Width <= most).Select(circle => Middle(circle.PointAt(0.0), circle.PointAt(0.5))),
            .. shape.Part.Places.Select(place => place.Place),
        ];
        Point2D[] holes = [.. Enumerable.Range(0, shape.Path.Count).Select(row => shape.Path[row].StartPoint)];
        foreach (var (from, to) in ((Point2D[], Point2D[])[])[(drawn, holes), (holes, drawn)])
        {
            var boxes = BoxTree.Build(to);
            foreach (var place in from)
            {
                if (boxes.Nearest(place, (item, at) => to[item].DistanceTo(at), double.PositiveInfinity, out var distance) < 0 || distance > tolerance) yield return place;
            }
        }

        var others = BoxTree.Build(holes);
        for (var hole = 0; hole < holes.Length; hole++)
        {
            others.Hide(hole);
            if (others.Nearest(holes[hole], (item, at) => holes[item].DistanceTo(at), double.PositiveInfinity, out var distance) >= 0 && distance < tolerance) yield return holes[hole];
            others.Show(hole);
        }

        static Point2D Middle(Point2D one, Point2D other) => new((one.X + other.X) / 2.0, (one.Y + other.Y) / 2.0);
    }

    private static Diagnostic NotAsStated(ShapedOperation shape, string what, Point2D place) =>
        OperationRules.NotAsStated.At(default, shape.Operation.Title, Wording.Get("OperationCheck." + what), FactText.Of(place.X), FactText.Of(place.Y)) with { Place = place };
}
