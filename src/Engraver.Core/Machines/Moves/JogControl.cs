namespace Engraver.Core.Machines.Moves;

/// <summary>The operator's requests to a running jog: its present speed, and its end. May be used from any thread.</summary>
/// <param name="first">The velocity with which it begins.</param>
public sealed class JogControl(JogVelocity first)
{
    private readonly Lock _guard = new();
    private readonly TaskCompletionSource _released = new();
    private JogVelocity _velocity = first;

    /// <summary>May change while the machine moves, but keeps its direction: another direction is another jog.</summary>
    public JogVelocity Velocity
    {
        get
        {
            lock (_guard) return _velocity;
        }

        set
        {
            lock (_guard) _velocity = value;
        }
    }

    /// <summary>Completes when the key is released.</summary>
    public Task Released => _released.Task;

    /// <summary>The key is released: the machine brakes. The brake is commanded on this thread, which does not wait for the reply.</summary>
    public void Release() => _released.TrySetResult();
}
