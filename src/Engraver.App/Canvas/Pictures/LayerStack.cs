using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Overlays;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Views;
using Engraver.Workbench.Views;

namespace Engraver.App.Canvas.Pictures;

/// <summary>The layers of a picture from the lowest up: drawing, its points, selection, machine, contours, path, engraved, recorded, rapids,
/// marks.</summary>
internal static class LayerStack
{
    public static IReadOnlyList<IPictureLayer> Create(CanvasContent content, CanvasView view)
    {
        var layers = new List<IPictureLayer>();
        AddDrawing(content, view, layers);
        AddPaths(content, layers);
        AddMarks(content, view, layers);
        return layers;
    }

    private static void AddDrawing(CanvasContent content, CanvasView view, List<IPictureLayer> layers)
    {
        if (content.Scene is not { } scene) return;
        var width = Math.Max(1.0, Math.Round(content.Scaling));
        if (content.Shown.HasFlag(CanvasLayers.Drawing)) layers.Add(new PrimitiveLayer(scene.Store, scene.Colours.PaletteFor(content.Theme), new LinePen(width)));
        if (content.Shown.HasFlag(CanvasLayers.Drawing)) layers.AddRange(scene.PointColours.Select(points => new MarkLayer([.. points.Select(place => new SceneMark(place, MarkKind.Point))], view, EntityColours.Resolve(content.Theme, points.Key.Colour, points.Key.IsFaded), content.Scaling)));
        if (content.Selected is { } selected) layers.Add(new PrimitiveLayer(scene.Store, [content.Theme.Selected], new LinePen(2.0 * width)) { EntityFilter = selected });
    }

    private static void AddPaths(CanvasContent content, List<IPictureLayer> layers)
    {
        var (overlay, theme, scale) = (content.Overlay, content.Theme, content.Scaling);
        var line = new LinePen(1.5 * scale);
        Add(CanvasLayers.Machine, () => new PrimitiveLayer(overlay.MachineEnvelope, [theme.Machine], new LinePen(scale, 12.0 * scale, 4.0 * scale)));
        Add(CanvasLayers.Contours, () => new PrimitiveLayer(overlay.Contours, [theme.ClosedContour, theme.InsideContour, theme.OpenContour], line));
        Add(CanvasLayers.Operations, () => new PrimitiveLayer(overlay.Operations, [.. theme.Operations], line), overlay.HasOperations);
        Add(CanvasLayers.CutPath, () => new PrimitiveLayer(overlay.CutPath, ColourRamp.Between(theme.SlowCut, theme.FastCut, OverlayScene.RampSteps), line));
        Add(CanvasLayers.Engraved, () => new PrimitiveLayer(overlay.CutPath, [theme.Engraved, theme.Remaining], new LinePen(2.0 * scale)) { FirstRemaining = content.EngravedMoves }, content.EngravedMoves > 0);
        Add(CanvasLayers.Recorded, () => new PrimitiveLayer(overlay.Recorded, ColourRamp.Between(theme.Engraved, theme.Finding, OverlayScene.RampSteps), line));
        Add(CanvasLayers.Trajectories, () => new PrimitiveLayer(overlay.Trajectories, ColourRamp.Between(theme.Engraved, theme.Finding, OverlayScene.RampSteps), line), overlay.Trajectories.Count > 0);
        Add(CanvasLayers.Rapids, () => new PrimitiveLayer(overlay.Rapids, [theme.Rapid], new LinePen(scale, 5.0 * scale, 4.0 * scale)));
        Add(CanvasLayers.Rapids, () => new PrimitiveLayer(overlay.Finish, [theme.Rapid], new LinePen(scale, 5.0 * scale, 4.0 * scale)));

        void Add(CanvasLayers kind, Func<IPictureLayer> make, bool wanted = true)
        {
            if (wanted && content.Shown.HasFlag(kind)) layers.Add(make());
        }
    }

    private static void AddMarks(CanvasContent content, CanvasView view, List<IPictureLayer> layers)
    {
        var (overlay, theme) = (content.Overlay, content.Theme);
        Add(CanvasLayers.StartPoints, () => overlay.StartMarks, theme.Start);
        Add(CanvasLayers.OrderNumbers, () => overlay.OrderMarks, theme.Direction);
        Add(CanvasLayers.WorkOrigin, () => overlay.OriginMarks, theme.Machine);
        Add(CanvasLayers.Trajectories, () => overlay.TrajectoryMarks, theme.Direction);
        Add(CanvasLayers.Findings, () => overlay.FindingMarks, theme.Finding);

        void Add(CanvasLayers kind, Func<IReadOnlyList<SceneMark>> made, uint colour)
        {
            if (content.Shown.HasFlag(kind) && made() is { Count: > 0 } marks) layers.Add(new MarkLayer(marks, view, colour, content.Scaling));
        }
    }
}
