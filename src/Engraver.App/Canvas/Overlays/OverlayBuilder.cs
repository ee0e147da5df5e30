using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Scenes;
using Engraver.Core;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Documents;

namespace Engraver.App.Canvas.Overlays;

/// <summary>Converts sequenced strokes and the toolpath (millimetres) to the layers of an overlay (drawing units).</summary>
internal static class OverlayBuilder
{
    /// <param name="scale">Of the drawing.</param>
    public static OverlayScene Build(PreparedJob job, DrawingScale scale, OverlayInputs inputs)
    {
        var (sequence, toolpath) = (job.Sequence, job.Toolpath);
        return new()
        {
            MoveCount = toolpath.Strokes.Sum(stroke => stroke.Moves.Count),
            Deferred = new DeferredOverlays(
                new(() => Contours(sequence, scale)),
                new(() => Operations(job, scale)),
                new(() => CutPath(toolpath, scale, inputs.LazyMoveSpeeds?.Invoke() ?? inputs.MoveSpeeds)),
                new(() => OrderMarks(toolpath, scale))),
            HasOperations = job.Passes.Count > 0,
            Rapids = Rapids(toolpath, scale),
            Recorded = RecordedPath(inputs.Recorded),
            MachineEnvelope = Envelope(inputs.MachineEnvelope),
            StartMarks = StartMarks(toolpath, scale),
            FindingMarks = FindingMarks(sequence.Discontinuities, scale, inputs.Findings),
            OriginMarks = OriginMark(inputs.WorkOrigin),
            LastEnd = LastEndOf(toolpath, scale),
            Finish = FinishLine(LastEndOf(toolpath, scale), inputs.Finish),
        };
    }

    /// <summary>Marks are created on access: a mark takes three times the memory of its point, and there may be millions.</summary>
    private static ComputedList<SceneMark> StartMarks(Toolpath toolpath, DrawingScale scale)
    {
        Point2D[] places = [.. toolpath.Strokes.Select(stroke => scale.ToDrawing(stroke.Start))];
        return new ComputedList<SceneMark>(places.Length, index => new SceneMark(places[index], MarkKind.Start));
    }

    /// <param name="findings">Points of other findings, drawing units.</param>
    private static ComputedList<SceneMark> FindingMarks(OpenEndList ends, DrawingScale scale, IReadOnlyList<Point2D> findings) =>
        new(ends.Count + findings.Count, index => new SceneMark(index < ends.Count ? scale.ToDrawing(ends.PlaceOf(index)) : findings[index - ends.Count], MarkKind.Finding));

    private static SceneMark[] OrderMarks(Toolpath toolpath, DrawingScale scale) =>
        [.. toolpath.Strokes.Select(stroke => new SceneMark(scale.ToDrawing(stroke.Start), MarkKind.Order, stroke.Moves[0].Segment.StartTangent, stroke.Index + 1))];

    public static IReadOnlyList<SceneMark> OriginMark(Point2D? origin) => origin is { } place ? [new SceneMark(place, MarkKind.Origin)] : [];

    /// <summary>The travel after the last stroke; empty if either end is unknown.</summary>
    public static PrimitiveStore FinishLine(Point2D? from, Point2D? to)
    {
        var store = new PrimitiveStoreBuilder();
        if (from is { } start && to is { } end && start != end) store.Add(Segment.FromLine(start, end), 0, 0);
        return store.Build();
    }

    private static Point2D? LastEndOf(Toolpath toolpath, DrawingScale scale) => toolpath.Strokes is [.., var last] ? scale.ToDrawing(last.End) : null;

    /// <summary>Lines between the polled positions while the tool is on.</summary>
    public static PrimitiveStore RecordedPath(IReadOnlyList<RecordedPlace> places)
    {
        var lines = new PrimitiveStoreBuilder();
        for (var i = 1; i < places.Count; i++)
        {
            if (places[i].ToolOn) lines.Add(Segment.FromLine(places[i - 1].Place, places[i].Place), i, StepOf(places[i].ErrorFraction));
        }

        return lines.Build();
    }

    private static PrimitiveStore Contours(SequencingResult sequence, DrawingScale scale)
    {
        var store = new PrimitiveStoreBuilder();
        foreach (var stroke in sequence.Strokes)
        {
            var kind = !stroke.Closed ? OverlayScene.Open : stroke.Inside >= 0 ? OverlayScene.ClosedInside : OverlayScene.ClosedOutside;
            foreach (var move in stroke.Moves) store.Add(scale.ToDrawing(move.Segment), stroke.Index, kind);
        }

        return store.Build();
    }

    private static PrimitiveStore Operations(PreparedJob job, DrawingScale scale)
    {
        var store = new PrimitiveStoreBuilder();
        if (job.Settings.Operations is not { } plan) return store.Build();
        var places = plan.Operations.Select((operation, place) => (operation.Id, place)).ToDictionary(pair => pair.Id, pair => CanvasTheme.OperationColour(pair.place));
        foreach (var (stroke, pass) in job.Toolpath.Strokes.Zip(job.Passes))
        {
            foreach (var move in stroke.Moves) store.Add(scale.ToDrawing(move.Segment), stroke.Index, places[pass.Operation.Id]);
        }

        return store.Build();
    }

    private static PrimitiveStore Rapids(Toolpath toolpath, DrawingScale scale)
    {
        var store = new PrimitiveStoreBuilder();
        var from = toolpath.ToolStart;
        foreach (var stroke in toolpath.Strokes)
        {
            store.Add(Segment.FromLine(scale.ToDrawing(from), scale.ToDrawing(stroke.Start)), stroke.Index, 0);
            from = stroke.End;
        }

        return store.Build();
    }

    private static PrimitiveStore CutPath(Toolpath toolpath, DrawingScale scale, IReadOnlyList<double> speeds)
    {
        var store = new PrimitiveStoreBuilder();
        foreach (var stroke in toolpath.Strokes)
        {
            foreach (var move in stroke.Moves) store.Add(scale.ToDrawing(move.Segment), store.Count, StepOf(store.Count < speeds.Count ? speeds[store.Count] : 1.0));
        }

        return store.Build();
    }

    public static PrimitiveStore Envelope(Bounds2D? box)
    {
        var store = new PrimitiveStoreBuilder();
        if (box is not { IsEmpty: false } known) return PrimitiveStore.Empty;
        Point2D[] corners = [new(known.MinX, known.MinY), new(known.MaxX, known.MinY), new(known.MaxX, known.MaxY), new(known.MinX, known.MaxY)];
        for (var i = 0; i < corners.Length; i++) store.Add(Segment.FromLine(corners[i], corners[(i + 1) % corners.Length]), i, 0);
        return store.Build();
    }

    private static ushort StepOf(double fraction) => (ushort)Math.Clamp((int)(fraction * OverlayScene.RampSteps), 0, OverlayScene.RampSteps - 1);
}
