using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Programs.Posting;

namespace Engraver.Galil.Jobs;

/// <summary>The job frame: what is added to a point of the motion program to get the controller's own counts. It is either given, or taken from the machine's
/// position at the start.</summary>
internal sealed class JobCoordinates
{
    private readonly CountsPoint _start;

    public JobCoordinates(MotionProgram program, JobOptions options)
    {
        _start = program.Start;
        Lift = options.DryRun ? DryRunLift.Of(program) : 0;
        Given = options.Frame is { } given ? given with { Z = given.Z + Lift } : null;
    }

    /// <summary>By how much the heights of the program are raised, counts: in a dry run of a tool that an axis drives, otherwise 0.</summary>
    public int Lift { get; }

    /// <summary>The frame that the job was given; null for none.</summary>
    public CountsPoint? Given { get; }

    /// <summary>The frame in force; null before <see cref="Take"/>.</summary>
    public CountsPoint? Taken { get; private set; }

    /// <summary>As <see cref="Taken"/>; zero before.</summary>
    public CountsPoint Origin => Taken ?? default;

    /// <summary>The machine's position when the frame was taken, the controller's own counts; null before.</summary>
    public CountsPoint? StartPosition { get; private set; }

    /// <summary>From the job frame to the controller's own counts.</summary>
    public ControllerFrame ToController => new(default, Origin);

    /// <summary>Defines the frame: the one that was given, otherwise the machine is at the program's start point.</summary>
    /// <param name="position">The machine's present position, the controller's own counts.</param>
    public void Take(CountsPoint position)
    {
        StartPosition = position;
        Taken = Given ?? position - _start + new CountsPoint(0, 0, Lift);
    }
}
