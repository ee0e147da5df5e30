using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Kerf;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Chaining;
using Engraver.Core.Sequencing.Nesting;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>The objects that the operator selects, joined to contours within CNCJOINTOL, regardless of their layers.</summary>
/// <param name="All">In the order and direction of the drawing, millimetres.</param>
/// <param name="Entities">Indices of the selected entities.</param>
internal sealed record SelectedContours(IReadOnlyList<SelectedContour> All, IReadOnlyList<int> Entities)
{
    /// <summary>Curve error that is sufficient to determine the side of a point, millimetres.</summary>
    private const double CurveError = 0.01;

    /// <exception cref="CommandException">The selection has no entity with a length.</exception>
    public static async Task<SelectedContours> TakeAsync(CommandContext context)
    {
        var selected = await ObjectSelection.GetAsync(context).ConfigureAwait(false);
        var (contours, findings) = Of(context.Drawing, context.Document.Current.Settings, selected);
        if (contours.All.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("Trajectories.NothingToFollow"));
        FindingMessages.Write(context, context.Drawing.FileName, findings.Where(found => found.Rule == SequencingRules.SmallGap), Severity.Warning);
        return contours;
    }

    /// <summary>The contours of some entities, empty if none has a length.</summary>
    public static (SelectedContours Contours, IReadOnlyList<Diagnostic> Findings) Of(Drawing drawing, DrawingSettings settings, IReadOnlyList<int> entities)
    {
        var job = new AnalysedJob(new LetteredJob(new DrawnJob(drawing, settings with { Enter = null, Kerf = KerfSide.Off, Operations = null }), LetteredDrawing.None(drawing)), ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, entities)));
        var chained = new StageRun(job, CancellationToken.None).To<ChainedJob>().Chained;
        var contours = OffsetDrawing.ContoursOf(chained).Select((contour, i) => new SelectedContour(contour, HandlesOf(chained, chained.Chain.Contours[i], drawing)));
        return (new SelectedContours([.. contours], entities), chained.Diagnostics);
    }

    /// <summary>The side of a point: inside or outside of all closed contours (islands are holes), and for an open contour whether the point is to its
    /// left.</summary>
    public OffsetSide SideOf(SelectedContour contour, Point2D place)
    {
        if (!contour.Contour.Closed) return IsLeftOf(contour.Contour.Segments, place) ? OffsetSide.Left : OffsetSide.Right;
        var region = new ContourRegion([.. BiarcFit.FitContour(All.Where(one => one.Contour.Closed).SelectMany(one => one.Contour.Segments), CurveError)]);
        return region.Contains(place) ? OffsetSide.In : OffsetSide.Out;
    }

    /// <summary>By the direction at the nearest point; at a joint by the sum of both directions.</summary>
    private static bool IsLeftOf(IReadOnlyList<Segment> segments, Point2D place)
    {
        var distances = segments.Select(segment => segment.DistanceTo(place)).ToArray();
        var least = distances.Min();
        var (way, from) = (default(Vector2D), default(Point2D));
        for (var i = 0; i < segments.Count; i++)
        {
            if (distances[i] > least + (1e-9 * (1.0 + least))) continue;
            var fraction = NearestFraction(segments[i], place);
            way += segments[i].TangentAt(fraction);
            from = segments[i].PointAt(fraction);
        }

        return way.Cross(place - from) > 0.0;
    }

    /// <summary>By bisection around the best of some samples: exact enough to determine the side.</summary>
    private static double NearestFraction(Segment segment, Point2D place)
    {
        const int Places = 256;
        double At(double fraction) => segment.PointAt(fraction).DistanceTo(place);
        var (best, step) = (Enumerable.Range(0, Places + 1).MinBy(i => At((double)i / Places)) / (double)Places, 1.0 / Places);
        for (var i = 0; i < 40; i++, step /= 2.0)
        {
            var (before, after) = (Math.Max(0.0, best - step), Math.Min(1.0, best + step));
            if (At(before) < At(best)) best = before;
            else if (At(after) < At(best)) best = after;
        }

        return best;
    }

    private static List<string> HandlesOf(ChainedTable chained, Contour contour, Drawing drawing)
    {
        var handles = new List<string>();
        foreach (var piece in contour.Pieces.Span)
        {
            if (drawing.SourceOf(chained.Kept.EntityIndexOf(piece.Row)).Handle is { } handle && !handles.Contains(handle)) handles.Add(handle);
        }

        return handles;
    }
}

/// <summary>A contour with the handles of its entities.</summary>
internal sealed record SelectedContour(OffsetContour Contour, IReadOnlyList<string> Handles);
