using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>Monitors the front end during a continuous jog: it must signal periodically that it is responsive and has the focus. A jog without signals is
/// released from another thread. Any thread.</summary>
/// <remarks>A hanging front end does not notice that a key is released, and the watchdog in the controller only monitors this process.</remarks>
public sealed class OperatorPresence(TimeProvider time, Action changed)
{
    /// <summary>Interval of the signals.</summary>
    public static readonly TimeSpan Beat = TimeSpan.FromMilliseconds(50);

    private static readonly TimeSpan s_patience = TimeSpan.FromMilliseconds(300);
    private readonly Lock _guard = new();
    private readonly List<HeldJog> _jogs = [];
    private ITimer? _watch;
    private long _heard;
    private long _looked;

    /// <summary>True while a jog is active or starting and signals are required.</summary>
    public bool IsNeeded
    {
        get
        {
            lock (_guard) return _jogs.Count > 0;
        }
    }

    /// <summary>A key is pressed: signals are required until the jog is disposed.</summary>
    public HeldJog Begin(JogVelocity velocity)
    {
        var jog = new HeldJog(new JogControl(velocity), End);
        lock (_guard)
        {
            _jogs.Add(jog);
            _heard = _looked = time.GetTimestamp();
            _watch ??= time.CreateTimer(_ => Look(), null, Beat, Beat);
        }

        changed();
        return jog;
    }

    /// <summary>Signals that the front end is responsive and has the focus.</summary>
    public void Sign()
    {
        lock (_guard) _heard = time.GetTimestamp();
    }

    /// <summary>The operator has left: releases every jog. The stop is sent on this thread without waiting for the reply.</summary>
    public void Leave()
    {
        foreach (var jog in Jogs()) jog.Lose(isLate: false);
    }

    private void Look()
    {
        lock (_guard)
        {
            var isHeldUp = time.GetElapsedTime(_looked) > 2 * Beat; // This process itself was delayed: pending signals may be processed right after this.
            _looked = time.GetTimestamp();
            if (isHeldUp || time.GetElapsedTime(_heard) < s_patience) return;
        }

        foreach (var jog in Jogs()) jog.Lose(isLate: true);
    }

    private HeldJog[] Jogs()
    {
        lock (_guard) return [.. _jogs];
    }

    private void End(HeldJog jog)
    {
        lock (_guard)
        {
            if (!_jogs.Remove(jog)) return;
            if (_jogs.Count == 0)
            {
                _watch?.Dispose();
                _watch = null;
            }
        }

        changed();
    }
}

/// <summary>One continuous jog: it moves while its key is pressed and the front end sends signals (<see cref="OperatorPresence"/>). Any thread.</summary>
public sealed class HeldJog : IDisposable
{
    private readonly TaskCompletionSource<bool> _lost = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Action<HeldJog> _end;

    internal HeldJog(JogControl control, Action<HeldJog> end) => (Control, _end) = (control, end);

    /// <summary>True after the jog was released for any reason.</summary>
    public bool IsReleased => Control.Released.IsCompleted;

    /// <summary>Completes when the jog is released without a key release: true for missing signals, false if the operator has left.</summary>
    public Task<bool> Lost => _lost.Task;

    internal JogControl Control { get; }

    /// <summary>Changes the speed in the same direction.</summary>
    public void Steer(double mmPerMinute) => Control.Velocity = Control.Velocity.At(mmPerMinute);

    /// <summary>The key is released: the machine decelerates. The stop is sent on this thread without waiting for the reply.</summary>
    public void Release() => Control.Release();

    public void Dispose()
    {
        Release();
        _end(this);
    }

    internal void Lose(bool isLate)
    {
        if (IsReleased) return;
        _lost.TrySetResult(isLate);
        Release();
    }
}
