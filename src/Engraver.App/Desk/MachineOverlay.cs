using Engraver.App.Canvas.Overlays;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Plots;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.App.Desk;

/// <summary>What the machine adds to the picture of a job: how far it reaches, where the drawing's zero lies on it, where it parks, and where it really
/// was. Equal while nothing of it has changed.</summary>
/// <param name="Zero">Machine millimetres at the drawing's zero; null while nobody knows.</param>
/// <param name="Run">The last run of this drawing, or the one under way, or one that was opened; null for none.</param>
/// <param name="Colour">What the colour of the run tells.</param>
internal sealed record MachineOverlay(PreparedJob? Job, Point2D? Zero, RecordedRun? Run, RunMeasure Colour)
{
    public static MachineOverlay Of(PreparedJob? job, MachineSession machine, RunMeasure colour)
    {
        if (job is null) return new MachineOverlay(null, null, null, colour);
        var frame = machine.LastPlacement(new MotionProgram(job.Settings.Machine, default, []), dryRun: false)?.Frame; // also of a job that would leave the travel: that is what is to be seen
        var run = machine.Recorded is { } recorded && ReferenceEquals(recorded.Job.DocumentDrawing, job.Drawing) ? recorded : null;
        return new MachineOverlay(job, frame is { } zero ? job.Settings.Machine.Scale.ToMillimetres(zero.X, zero.Y) : null, run, colour);
    }

    /// <summary>In drawing units, over what the job says by itself.</summary>
    public OverlayInputs Over(OverlayInputs inputs)
    {
        if (Job is null) return inputs;
        var scale = Job.Drawing.Scale;
        return inputs with
        {
            WorkOrigin = Zero is null ? null : default(Point2D), // the origin is where the drawing's zero lies
            MachineEnvelope = EnvelopeOf(Job, scale),
            Finish = FinishOf(Job) is { } finish ? scale.ToDrawing(finish) : null,
            Recorded = Run is null ? [] : PlacesOf(Run, scale),
        };
    }

    private IReadOnlyList<RecordedPlace> PlacesOf(RecordedRun run, DrawingScale scale)
    {
        var fractions = run.Colours(Colour);
        return [.. run.Trace.Places.Select((place, i) => new RecordedPlace(scale.ToDrawing(place.Place), fractions[i], place.ToolOn))];
    }

    /// <summary>The travel of the profile in drawing units; null where an axis has none, or nobody knows where the drawing lies in it.</summary>
    private Bounds2D? EnvelopeOf(PreparedJob job, DrawingScale scale) => job.Settings.Machine.Axes is { X.Travel: { } x, Y.Travel: { } y } && Zero is { } zero
        ? scale.ToDrawing(new Bounds2D(x.Least - zero.X, y.Least - zero.Y, x.Most - zero.X, y.Most - zero.Y))
        : null;

    /// <summary>Where the machine goes after the last stroke, millimetres of the drawing.</summary>
    private Point2D? FinishOf(PreparedJob job)
    {
        if (job.Motion.Program?.Finish is { } finish) return job.Settings.Machine.Scale.ToMillimetres(finish.X, finish.Y);
        return job.Settings is { Finish: FinishPlace.Park, Machine.Park: { } park } && Zero is { } zero ? new Point2D(park.X - zero.X, park.Y - zero.Y) : null;
    }
}
