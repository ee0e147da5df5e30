using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Galil.Tests.Jobs.Holds;

/// <summary>An operator who holds a job, moves the machine by hand during the hold, and resumes it. Acts on the job's own thread, at its reports.</summary>
/// <param name="at">When to hold.</param>
/// <param name="moves">In order; a key is released once <paramref name="released"/> returns true.</param>
internal sealed class MovingOperator(Func<JobProgress, bool> at, Func<JobProgress, bool> released, params MoveInHold[] moves) : IProgress<JobProgress>
{
    private int _next;
    private bool _asked;

    public JobControl Control { get; } = new();

    public List<Task<JobResult>> Moves { get; } = [];

    /// <summary>Called when the moves have ended; null for resuming.</summary>
    public Action? WhenMoved { get; init; }

    /// <summary>Called at every report during a move.</summary>
    public Action<JobProgress>? WhileMoving { get; init; }

    /// <summary>The phases reported during a move.</summary>
    public HashSet<JobPhase> PhasesMeanwhile { get; } = [];

    /// <summary>Position of the hold, job frame.</summary>
    public CountsPoint HeldAt { get; private set; }

    public void Report(JobProgress value)
    {
        if (!_asked && value.Phase == JobPhase.Running && at(value))
        {
            _asked = true;
            Control.Hold();
        }

        if (Moves.Count > 0 && !Moves[^1].IsCompleted) Watch(value);
        else if (value.Phase == JobPhase.Held) Act(value);
    }

    private void Watch(JobProgress value)
    {
        PhasesMeanwhile.Add(value.Phase);
        WhileMoving?.Invoke(value);
        if (released(value)) moves[_next - 1].Jog?.Release();
    }

    private void Act(JobProgress value)
    {
        if (_next == 0) HeldAt = value.Place;
        if (_next < moves.Length) Moves.Add(Control.MoveAsync(moves[_next++]));
        else if (WhenMoved is { } act) act();
        else Control.Resume();
    }
}
