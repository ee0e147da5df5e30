using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Trajectories;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Canvas.Overlays;

/// <summary>Trajectories (millimetres) as the curve that is really run, coloured by its deviation, with points and corners (drawing units).</summary>
internal static class TrajectoryOverlay
{
    /// <summary>Parts of each step with a colour of their own.</summary>
    private const int Parts = 8;

    /// <summary>Points shown in all; the curve alone is shown of more.</summary>
    private const int MostMarks = 50_000;

    /// <param name="scale">Of the drawing.</param>
    public static PrimitiveStore Curves(IReadOnlyList<DocumentTrajectory> trajectories, DrawingScale scale)
    {
        var store = new PrimitiveStoreBuilder();
        for (var i = 0; i < trajectories.Count; i++)
        {
            foreach (var part in TrajectoryCurve.Parts(trajectories[i].Curve, Parts))
            {
                var step = (ushort)Math.Clamp((int)(part.Deviation / trajectories[i].MaxErrorMm * OverlayScene.RampSteps), 0, OverlayScene.RampSteps - 1);
                store.Add(Segment.FromCurve(scale.ToDrawing(part.Curve.Curve)), i, step);
            }
        }

        return store.Build();
    }

    /// <summary>Corners first, for marks that would cover each other are left out.</summary>
    public static IReadOnlyList<SceneMark> Marks(IReadOnlyList<DocumentTrajectory> trajectories, DrawingScale scale)
    {
        SceneMark At(Point2D place, MarkKind kind) => new(scale.ToDrawing(place), kind);
        var corners = trajectories.SelectMany(one => TrajectoryCurve.CornersOf(one.Curve)).Select(place => At(place, MarkKind.Finding));
        var points = trajectories.SelectMany(one => one.Curve.Lines.Skip(1).SkipLast(1)).Take(MostMarks).Select(place => At(place, MarkKind.Start));
        return [.. corners, .. points];
    }
}
