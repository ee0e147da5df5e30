using Engraver.App.Canvas.Marks;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Canvas.Overlays;

/// <summary>The overlays of a drawing, made ready for the canvas. Immutable; drawing units.</summary>
public sealed class OverlayScene
{
    /// <summary>Steps of the colours of speed and of a run.</summary>
    internal const int RampSteps = 64;

    internal const ushort ClosedOutside = 0;
    internal const ushort ClosedInside = 1;
    internal const ushort Open = 2;

    internal OverlayScene()
    {
    }

    /// <summary>No overlays.</summary>
    public static OverlayScene Empty { get; } = new();

    /// <summary>Cutting moves of the job; the numbers of the engraved layer run from 0 to it.</summary>
    public int MoveCount { get; internal init; }

    /// <summary>Contours as strokes; the entity of a primitive is its stroke, the colour one of the three kinds. Made by the first picture that shows
    /// them.</summary>
    internal PrimitiveStore Contours => Unseen.Contours.Value;

    internal PrimitiveStore Rapids { get; init; } = PrimitiveStore.Empty;

    /// <summary>The moves as they are cut; the entity of a primitive is the number of the move in the whole job, the colour its speed. Made by the first
    /// picture that shows them.</summary>
    internal PrimitiveStore CutPath => Unseen.CutPath.Value;

    /// <summary>Colour: what the operator chose (CNCTRACE).</summary>
    internal PrimitiveStore Recorded { get; init; } = PrimitiveStore.Empty;

    /// <summary>The machine envelope.</summary>
    internal PrimitiveStore Machine { get; init; } = PrimitiveStore.Empty;

    /// <summary>The way to where the machine goes after the last stroke.</summary>
    internal PrimitiveStore Finish { get; init; } = PrimitiveStore.Empty;

    /// <summary>The curves that a controller runs through the points of the trajectories; colour: the deviation as a part of the error asked for.</summary>
    internal PrimitiveStore Trajectories { get; init; } = PrimitiveStore.Empty;

    /// <summary>The corners and points of the trajectories.</summary>
    internal IReadOnlyList<SceneMark> TrajectoryMarks { get; init; } = [];

    /// <summary>Made by the first picture that shows them.</summary>
    internal IReadOnlyList<SceneMark> OrderMarks => Unseen.OrderMarks.Value;

    /// <summary>What most pictures do not show; 42 bytes and more a segment.</summary>
    internal UnseenOverlays Unseen { get; init; } = UnseenOverlays.None;

    internal IReadOnlyList<SceneMark> StartMarks { get; init; } = [];

    internal IReadOnlyList<SceneMark> FindingMarks { get; init; } = [];

    internal IReadOnlyList<SceneMark> OriginMarks { get; init; } = [];

    /// <summary>The overlays of a prepared job and of the other inputs.</summary>
    public static OverlayScene From(PreparedJob job, OverlayInputs? inputs = null)
    {
        ArgumentNullException.ThrowIfNull(job);
        return OverlayBuilder.Build(job.Sequence, job.Toolpath, job.Drawing.Scale, inputs ?? OverlayInputs.None);
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

    /// <summary>The same scene with what else is known of the machine now.</summary>
    /// <param name="inputs">Of these the envelope, the origin, the finish and the recorded places.</param>
    public OverlayScene WithMachine(OverlayInputs inputs)
    {
        ArgumentNullException.ThrowIfNull(inputs);
        return new OverlayScene
        {
            Unseen = Unseen, MoveCount = MoveCount, Rapids = Rapids, StartMarks = StartMarks, FindingMarks = FindingMarks, LastEnd = LastEnd,
            Trajectories = Trajectories, TrajectoryMarks = TrajectoryMarks,
            Machine = OverlayBuilder.Envelope(inputs.MachineEnvelope),
            OriginMarks = OverlayBuilder.OriginMark(inputs.WorkOrigin),
            Finish = OverlayBuilder.WayTo(LastEnd, inputs.Finish),
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
            Unseen = Unseen, MoveCount = MoveCount, Rapids = Rapids, StartMarks = StartMarks, FindingMarks = FindingMarks, LastEnd = LastEnd,
            Machine = Machine, OriginMarks = OriginMarks, Finish = Finish, Recorded = Recorded,
            Trajectories = TrajectoryOverlay.Curves(trajectories, scale),
            TrajectoryMarks = TrajectoryOverlay.Marks(trajectories, scale),
        };
    }

    /// <summary>Where the last stroke ends, drawing units; null when there is none.</summary>
    internal Point2D? LastEnd { get; init; }
}

/// <summary>Overlays that are made when a picture shows them for the first time, on the thread that draws it.</summary>
internal sealed record UnseenOverlays(Lazy<PrimitiveStore> Contours, Lazy<PrimitiveStore> CutPath, Lazy<IReadOnlyList<SceneMark>> OrderMarks)
{
    public static UnseenOverlays None { get; } = new(new(PrimitiveStore.Empty), new(PrimitiveStore.Empty), new(Array.Empty<SceneMark>()));

    /// <summary>One of them has been made.</summary>
    public bool IsAnyMade => Contours.IsValueCreated || CutPath.IsValueCreated || OrderMarks.IsValueCreated;
}

/// <summary>A recorded position of the machine.</summary>
/// <param name="Place">Drawing units.</param>
/// <param name="ErrorFraction">What is coloured, as a part of what is tolerated or of the largest: 0 none, 1 and above all of it.</param>
/// <param name="ToolOn">False where the tool was up: the line to it is left out.</param>
public readonly record struct RecordedPlace(Point2D Place, double ErrorFraction, bool ToolOn);
