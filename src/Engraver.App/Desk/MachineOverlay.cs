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

/// <summary>What the machine adds to the picture of a job: its travel, its work origin, the park position, and the recorded path. Equal while none of these
/// has changed.</summary>
/// <param name="Zero">Machine position of the drawing's zero, millimetres; null if unknown.</param>
/// <param name="Run">The last run of this drawing and plate, the current one, or one that was opened; null for none.</param>
/// <param name="Colour">The measure that the colour of the run shows.</param>
internal sealed record MachineOverlay(PreparedJob? Job, Point2D? Zero, RecordedRun? Run, RunMeasure Colour)
{
    public static MachineOverlay Of(PreparedJob? job, MachineSession machine, RunMeasure colour)
    {
        if (job is null) return new MachineOverlay(null, null, null, colour);
        var frame = machine.Origins.LastPlacement(new MotionProgram(job.Settings.CuttingMachine, default, []), dryRun: false)?.Frame; // also of a job that would leave the travel: that is what is to be seen
        var run = machine.Runs.Recorded is { } recorded && ReferenceEquals(recorded.Job.DocumentDrawing, job.DocumentDrawing) && (recorded.Job.Trajectories is not null || recorded.Job.Plate == job.Plate) ? recorded : null;
        return new MachineOverlay(job, frame is { } zero ? job.Settings.CuttingMachine.Scale.ToMillimetres(zero.X, zero.Y) : null, run, colour);
    }

    /// <summary>The inputs with the machine data added, in drawing units.</summary>
    public OverlayInputs ApplyTo(OverlayInputs inputs)
    {
        if (Job is null) return inputs;
        var scale = Job.Drawing.Scale;
        return inputs with
        {
            WorkOrigin = Zero is null ? null : default(Point2D), // the work origin is the zero of the drawing
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

    /// <summary>The travel of the profile in drawing units; null if an axis has none, or if the work origin is unknown.</summary>
    private Bounds2D? EnvelopeOf(PreparedJob job, DrawingScale scale) => job.Settings.CuttingMachine.Axes is { X.Travel: { } x, Y.Travel: { } y } && Zero is { } zero
        ? scale.ToDrawing(new Bounds2D(x.Min - zero.X, y.Min - zero.Y, x.Max - zero.X, y.Max - zero.Y))
        : null;

    /// <summary>Machine position after the last stroke, millimetres of the drawing.</summary>
    private Point2D? FinishOf(PreparedJob job)
    {
        if (job.Motion.Program?.Finish is { } finish) return job.Settings.CuttingMachine.Scale.ToMillimetres(finish.X, finish.Y);
        return job.Settings is { Finish: FinishPlace.Park, Machine.Park: { } park } && Zero is { } zero ? new Point2D(park.X - zero.X, park.Y - zero.Y) : null;
    }
}
