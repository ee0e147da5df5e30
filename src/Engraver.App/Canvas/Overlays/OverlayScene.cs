using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Canvas.Overlays;

/// <summary>The overlays of a drawing, prepared for the canvas. Immutable; drawing units.</summary>
public sealed class OverlayScene
{
    /// <summary>Number of steps of the colours of speed and of a run.</summary>
    internal const int RampSteps = 64;

    internal const ushort ClosedOutside = 0;
    internal const ushort ClosedInside = 1;
    internal const ushort Open = 2;

    internal OverlayScene()
    {
    }

    /// <summary>No overlays.</summary>
    public static OverlayScene Empty { get; } = new();

    /// <summary>Number of cutting moves of the job; the engraved layer uses 0 to this number.</summary>
    public int MoveCount { get; internal init; }

    /// <summary>Contours as strokes; the entity of a primitive is its stroke, the colour one of the three kinds. Created when a picture first shows
    /// them.</summary>
    internal PrimitiveStore Contours => Deferred.Contours.Value;

    internal PrimitiveStore Rapids { get; init; } = PrimitiveStore.Empty;

    /// <summary>The moves of the operations; the entity of a primitive is its stroke, the colour the place of the operation in the list. Created when a picture
    /// first shows them.</summary>
    internal PrimitiveStore Operations => Deferred.Operations.Value;

    /// <summary>The job has operations.</summary>
    internal bool HasOperations { get; init; }

    /// <summary>The moves in cutting order; the entity of a primitive is the number of the move in the whole job, the colour its speed. Created when a
    /// picture first shows them.</summary>
    internal PrimitiveStore CutPath => Deferred.CutPath.Value;

    /// <summary>Colour: the value that the operator chose (CNCTRACE).</summary>
    internal PrimitiveStore Recorded { get; init; } = PrimitiveStore.Empty;

    /// <summary>The machine envelope.</summary>
    internal PrimitiveStore MachineEnvelope { get; init; } = PrimitiveStore.Empty;

    /// <summary>The travel to the finish position after the last stroke.</summary>
    internal PrimitiveStore Finish { get; init; } = PrimitiveStore.Empty;

    /// <summary>The curves that a controller runs through the points of the trajectories; colour: the deviation as a fraction of the requested
    /// error.</summary>
    internal PrimitiveStore Trajectories { get; init; } = PrimitiveStore.Empty;

    /// <summary>The corners and points of the trajectories.</summary>
    internal IReadOnlyList<SceneMark> TrajectoryMarks { get; init; } = [];

    /// <summary>Created when a picture first shows them.</summary>
    internal IReadOnlyList<SceneMark> OrderMarks => Deferred.OrderMarks.Value;

    /// <summary>Overlays that most pictures do not show; at least 42 bytes per segment.</summary>
    internal DeferredOverlays Deferred { get; init; } = DeferredOverlays.None;

    internal IReadOnlyList<SceneMark> StartMarks { get; init; } = [];

    internal IReadOnlyList<SceneMark> FindingMarks { get; init; } = [];

    internal IReadOnlyList<SceneMark> OriginMarks { get; init; } = [];

    /// <summary>The overlays of a prepared job and of the other inputs.</summary>
    public static OverlayScene From(PreparedJob job, OverlayInputs? inputs = null)
    {
        ArgumentNullException.ThrowIfNull(job);
        return OverlayBuilder.Build(job, job.Drawing.Scale, inputs ?? OverlayInputs.None);
    }

    /// <summary>The nearest finding within a distance, drawing units; null when there is none.</summary>
    public Point2D? FindingNear(Point2D place, double within)
    {
        Point2D? nearest = null;
        foreach (var mark in FindingMarks)
        {
            var distance = mark.Place.DistanceTo(place);
            if (distance > within) continue;
            (nearest, within) = (mark.Place, distance);
        }

        return nearest;
    }

    /// <summary>The same scene with other machine data.</summary>
    /// <param name="inputs">The envelope, the origin, the finish and the recorded positions are used.</param>
    public OverlayScene WithMachine(OverlayInputs inputs)
    {
        ArgumentNullException.ThrowIfNull(inputs);
        return new OverlayScene
        {
            Deferred = Deferred, HasOperations = HasOperations, MoveCount = MoveCount, Rapids = Rapids, StartMarks = StartMarks, FindingMarks = FindingMarks, LastEnd = LastEnd,
            Trajectories = Trajectories, TrajectoryMarks = TrajectoryMarks,
            MachineEnvelope = OverlayBuilder.Envelope(inputs.MachineEnvelope),
            OriginMarks = OverlayBuilder.OriginMark(inputs.WorkOrigin),
            Finish = OverlayBuilder.FinishLine(LastEnd, inputs.Finish),
            Recorded = OverlayBuilder.RecordedPath(inputs.Recorded),
        };
    }

    /// <summary>The same scene with other trajectories.</summary>
    /// <param name="scale">Of the drawing.</param>
    public OverlayScene WithTrajectories(IReadOnlyList<DocumentTrajectory> trajectories, DrawingScale scale)
    {
        ArgumentNullException.ThrowIfNull(trajectories);
        return new OverlayScene
        {
            Deferred = Deferred, HasOperations = HasOperations, MoveCount = MoveCount, Rapids = Rapids, StartMarks = StartMarks, FindingMarks = FindingMarks, LastEnd = LastEnd,
            MachineEnvelope = MachineEnvelope, OriginMarks = OriginMarks, Finish = Finish, Recorded = Recorded,
            Trajectories = TrajectoryOverlay.Curves(trajectories, scale),
            TrajectoryMarks = TrajectoryOverlay.Marks(trajectories, scale),
        };
    }

    /// <summary>End of the last stroke, drawing units; null if there is none.</summary>
    internal Point2D? LastEnd { get; init; }
}

/// <summary>Overlays that are created when a picture first shows them, on the thread that draws it.</summary>
internal sealed record DeferredOverlays(Lazy<PrimitiveStore> Contours, Lazy<PrimitiveStore> Operations, Lazy<PrimitiveStore> CutPath, Lazy<IReadOnlyList<SceneMark>> OrderMarks)
{
    public static DeferredOverlays None { get; } = new(new(PrimitiveStore.Empty), new(PrimitiveStore.Empty), new(PrimitiveStore.Empty), new(Array.Empty<SceneMark>()));

    /// <summary>At least one of them has been created.</summary>
    public bool IsAnyCreated => Contours.IsValueCreated || Operations.IsValueCreated || CutPath.IsValueCreated || OrderMarks.IsValueCreated;
}
