namespace Engraver.Core.Machines.Moves;

/// <summary>Jogs one after the other on a machine that is kept ready for the next one: the preparation of the controller, which takes seconds over a serial
/// line, is done once. May be used from any thread.</summary>
/// <remarks>The operator's side calls <see cref="Press"/> and <see cref="Leave"/>, the driver's side the rest.</remarks>
public sealed class JogStandby
{
    private readonly Lock _guard = new();
    private (JogControl Control, TaskCompletionSource<JobResult> Ended)? _jog;
    private bool _isLeaving;

    /// <summary>Called with each reading of the machine between two jogs, on the driver's thread.</summary>
    public Action<MachineReading>? Seen { get; init; }

    /// <summary>The key of the requested or running jog; null between two jogs.</summary>
    public JogControl? Pressed
    {
        get
        {
            lock (_guard) return _jog?.Control;
        }
    }

    /// <summary>No further jog is requested.</summary>
    public bool IsLeaving
    {
        get
        {
            lock (_guard) return _isLeaving;
        }
    }

    /// <summary>A key is pressed.</summary>
    /// <returns>Completes when the machine is at rest, with how the jog ended; null when this standby is over or a jog is in progress.</returns>
    public Task<JobResult>? Press(JogControl control)
    {
        ArgumentNullException.ThrowIfNull(control);
        lock (_guard)
        {
            if (_isLeaving || _jog is not null) return null;
            var ended = new TaskCompletionSource<JobResult>(TaskCreationOptions.RunContinuationsAsynchronously);
            _jog = (control, ended);
            return ended.Task;
        }
    }

    /// <summary>The machine is no longer kept ready; a running jog first continues to its end.</summary>
    public void Leave()
    {
        lock (_guard) _isLeaving = true;
    }

    /// <summary>The jog has ended, and the machine is ready for the next one.</summary>
    public void CompleteJog(JobResult result) => TakeJog(isOver: false)?.TrySetResult(result);

    /// <summary>The machine is no longer kept ready; a requested or running jog ended with this result.</summary>
    public void Complete(JobResult result) => TakeJog(isOver: true)?.TrySetResult(result);

    /// <summary>The machine is no longer kept ready because of a failure.</summary>
    public void Complete(Exception failure) => TakeJog(isOver: true)?.TrySetException(failure);

    private TaskCompletionSource<JobResult>? TakeJog(bool isOver)
    {
        lock (_guard)
        {
            var ended = _jog?.Ended;
            _jog = null;
            _isLeaving |= isOver;
            return ended;
        }
    }
}
