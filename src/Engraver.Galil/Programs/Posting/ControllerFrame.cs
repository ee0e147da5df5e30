using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Converts from the job's frame to the controller's own coordinates, which rapids (PA) need: both describe the position of the machine at the start
/// of the job.</summary>
/// <param name="JobStart">This position in the job's frame.</param>
/// <param name="ControllerAtStart">The reading of the controller at this position.</param>
public readonly record struct ControllerFrame(CountsPoint JobStart, CountsPoint ControllerAtStart)
{
    /// <summary>True when this position of the job's frame is within the controller's range of counts.</summary>
    public bool IsInRange(CountsPoint job) => IsInRange(job, 0) && IsInRange(job, 1) && IsInRange(job, 2);

    /// <summary>Throws <see cref="OverflowException"/> when the position is outside the controller's range of counts.</summary>
    public CountsPoint Of(CountsPoint job) => new(
        checked((int)(job.X - JobStart.X + ControllerAtStart.X)),
        checked((int)(job.Y - JobStart.Y + ControllerAtStart.Y)),
        HeightOf(job.Z));

    /// <summary>The same for a height only.</summary>
    public int HeightOf(int job) => checked((int)((long)job - JobStart.Z + ControllerAtStart.Z));

    /// <summary>True when all of these extents are within the controller's range of counts.</summary>
    public bool IsInRange(MotionExtents job) => IsInRange(new CountsPoint(job.MinX, job.MinY)) && IsInRange(new CountsPoint(job.MaxX, job.MaxY));

    private bool IsInRange(CountsPoint job, int axis) => Math.Abs(job[axis] - JobStart[axis] + ControllerAtStart[axis]) <= int.MaxValue;
}
