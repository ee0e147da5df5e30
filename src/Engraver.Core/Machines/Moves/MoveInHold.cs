namespace Engraver.Core.Machines.Moves;

/// <summary>A move by hand that the operator requests while a job is held at standstill: to a point, by a step, or as long as a key is held.</summary>
public sealed class MoveInHold
{
    private readonly TaskCompletionSource<JobResult> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    private MoveInHold()
    {
    }

    /// <summary>The key that is held; null for a move with a goal.</summary>
    public JogControl? Jog { get; private init; }

    /// <summary>Where a move without a key ends: the controller's own counts.</summary>
    public Func<CountsPoint, CountsPoint> GoalFrom { get; private init; } = static here => here;

    /// <summary>The height is part of the goal; otherwise it does not change.</summary>
    public bool WithHeight { get; private init; }

    /// <summary>Speed of each axis, mm/min; null for the profile's rapid speed.</summary>
    public double? MmPerMinute { get; private init; }

    /// <summary>How the move ended.</summary>
    public Task<JobResult> Ended => _completion.Task;

    /// <summary>A move that lasts as long as a key is held.</summary>
    public static MoveInHold While(JogControl key) => new() { Jog = key };

    /// <summary>A move to a point, in the controller's own counts.</summary>
    public static MoveInHold To(CountsPoint goal, bool withHeight, double? mmPerMinute = null) => new() { GoalFrom = _ => goal, WithHeight = withHeight, MmPerMinute = mmPerMinute };

    /// <summary>A move by some counts from the present position of the machine.</summary>
    public static MoveInHold By(CountsPoint step) => new() { GoalFrom = here => here + step, WithHeight = step.Z != 0 };

    /// <summary>Called once by the job, through <see cref="JobControl.CompleteMove"/>.</summary>
    internal void Complete(JobResult result) => _completion.TrySetResult(result);
}
