namespace Engraver.Galil.Programs;

/// <summary>From the job's frame to the controller's own coordinates, which rapids (PA) need: both meet where the machine stands when the job starts.</summary>
/// <param name="JobStart">That place in the job's frame.</param>
/// <param name="ControllerAtStart">What the controller's position reads there.</param>
public readonly record struct ControllerFrame(CountsPoint JobStart, CountsPoint ControllerAtStart)
{
    /// <summary>True when the controller can count to this place of the job's frame.</summary>
    public bool Holds(CountsPoint job) => Math.Max(Math.Abs((long)job.X - JobStart.X + ControllerAtStart.X), Math.Abs((long)job.Y - JobStart.Y + ControllerAtStart.Y)) <= int.MaxValue;

    /// <summary>Throws <see cref="OverflowException"/> when the controller could not count that far from where it stands.</summary>
    public CountsPoint Of(CountsPoint job) => new(
        checked((int)((long)job.X - JobStart.X + ControllerAtStart.X)),
        checked((int)((long)job.Y - JobStart.Y + ControllerAtStart.Y)));
}
