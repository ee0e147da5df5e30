namespace Engraver.Galil.Jobs;

/// <summary>The operator's stop as a job receives it: first the bytes that brake the machine are sent, then the job's own waits end.</summary>
/// <remarks>Code that waits on a token continues inside the call that cancels it, and the last one to wait is the first to continue. On the operator's token
/// itself the whole end of a job could run before the braking that was registered at its beginning.</remarks>
internal sealed class StopOrder : IDisposable
{
    private readonly CancellationTokenSource _work = new(); // not disposed: it may still have to end a wait, and it holds no timer
    private readonly CancellationToken _operator;
    private readonly CancellationTokenRegistration _pressed;
    private volatile Action? _brake;

    /// <param name="stop">The operator's.</param>
    public StopOrder(CancellationToken stop)
    {
        _operator = stop;
        _pressed = stop.UnsafeRegister(order => ((StopOrder)order!).Obey(), this);
    }

    /// <summary>The token of the job's waits: cancelled once the braking has been sent.</summary>
    public CancellationToken Work => _work.Token;

    /// <summary>The same for a command that is about to be sent: after the press none is sent that could begin a motion, also while the braking is being
    /// sent.</summary>
    /// <exception cref="OperationCanceledException">The operator has pressed.</exception>
    public CancellationToken ToSend()
    {
        _operator.ThrowIfCancellationRequested();
        return _work.Token;
    }

    /// <summary>The operator has pressed; what a poll shows from here on may be an effect of it.</summary>
    public bool IsPressed => _operator.IsCancellationRequested;

    /// <summary>Brakes the machine on a stop, at once and without waiting. Null: a stop only ends the job's waits.</summary>
    public void BrakeBy(Action? brake) => _brake = brake;

    public void Dispose() => _pressed.Dispose();

    private void Obey()
    {
        _brake?.Invoke();
        _work.Cancel();
    }
}
