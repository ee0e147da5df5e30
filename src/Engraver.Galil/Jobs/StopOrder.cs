namespace Engraver.Galil.Jobs;

/// <summary>The operator's stop as a job hears it: first the bytes that brake the machine go out, then the job's own waits end.</summary>
/// <remarks>Whatever waits on a token goes on inside the call that cancels it, and who began to wait last goes first. On the operator's token itself the
/// whole end of a job could run before the braking that was registered at its beginning.</remarks>
internal sealed class StopOrder : IDisposable
{
    private readonly CancellationTokenSource _work = new(); // not disposed: what waits on it may still be told, and it holds no timer
    private readonly CancellationToken _operator;
    private readonly CancellationTokenRegistration _pressed;
    private volatile Action? _brake;

    /// <param name="stop">The operator's.</param>
    public StopOrder(CancellationToken stop)
    {
        _operator = stop;
        _pressed = stop.UnsafeRegister(order => ((StopOrder)order!).Obey(), this);
    }

    /// <summary>What a job waits on: cancelled once the braking is on its way.</summary>
    public CancellationToken Work => _work.Token;

    /// <summary>The same for a command that is about to be sent: behind the press none goes out that could begin a motion, also while the braking is on its
    /// way.</summary>
    /// <exception cref="OperationCanceledException">The operator has pressed.</exception>
    public CancellationToken ToSend()
    {
        _operator.ThrowIfCancellationRequested();
        return _work.Token;
    }

    /// <summary>The operator has pressed; what is seen of the machine from here on may be an effect of it.</summary>
    public bool IsPressed => _operator.IsCancellationRequested;

    /// <summary>The machine is the job's: a stop brakes it at once, without waiting. Null: a stop only ends the job's waits.</summary>
    public void BrakeBy(Action? brake) => _brake = brake;

    public void Dispose() => _pressed.Dispose();

    private void Obey()
    {
        _brake?.Invoke();
        _work.Cancel();
    }
}
