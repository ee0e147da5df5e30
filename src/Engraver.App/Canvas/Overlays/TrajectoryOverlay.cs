using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Canvas.Overlays;

/// <summary>Trajectories (millimetres) as the curve that the controller runs, coloured by its deviation, with points and corners (drawing units).</summary>
internal static class TrajectoryOverlay
{
    /// <summary>Parts of each step that have their own colour.</summary>
    private const int PartsPerStep = 8;

    /// <summary>Maximum number of points shown; above it only the curve is shown.</summary>
    private const int MaxMarks = 50_000;

    /// <param name="scale">Of the drawing.</param>
    public static PrimitiveStore Curves(IReadOnlyList<DocumentTrajectory> trajectories, DrawingScale scale)
    {
        var store = new PrimitiveStoreBuilder();
        for (var i = 0; i < trajectories.Count; i++)
        {
            foreach (var part in TrajectoryCurve.Parts(trajectories[i].Curve, PartsPerStep))
            {
                var step = (ushort)Math.Clamp((int)(part.Deviation / trajectories[i].MaxErrorMm * OverlayScene.RampSteps), 0, OverlayScene.RampSteps - 1);
                store.Add(Segment.FromCurve(scale.ToDrawing(part.Curve.Curve)), i, step);
            }
        }

        return store.Build();
    }

    /// <summary>Corners first, because marks that would overlap are omitted.</summary>
    public static IReadOnlyList<SceneMark> Marks(IReadOnlyList<DocumentTrajectory> trajectories, DrawingScale scale)
    {
        SceneMark At(Point2D place, MarkKind kind) => new(scale.ToDrawing(place), kind);
        var corners = trajectories.SelectMany(one => TrajectoryCurve.CornersOf(one.Curve)).Select(place => At(place, MarkKind.Finding));
        var points = trajectories.SelectMany(one => one.Curve.Lines.Skip(1).SkipLast(1)).Take(MaxMarks).Select(place => At(place, MarkKind.Start));
        return [.. corners, .. points];
    }
}
