using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>Monitors the front end during a continuous jog: it must signal periodically that it is responsive and has the focus. A jog without signals is
/// released from another thread. Any thread.</summary>
/// <remarks>A hanging front end does not notice that a key is released, and the watchdog in the controller only monitors this process.</remarks>
public sealed class OperatorPresence(TimeProvider time, Action changed)
{
    /// <summary>Interval of the signals.</summary>
    public static readonly TimeSpan SignInterval = TimeSpan.FromMilliseconds(50);

    private static readonly TimeSpan s_timeout = TimeSpan.FromMilliseconds(300);
    private readonly Lock _guard = new();
    private readonly List<ContinuousJog> _jogs = [];
    private ITimer? _watch;
    private long _lastSign;
    private long _lastCheck;

    /// <summary>True while a jog is active or starting and signals are required.</summary>
    public bool IsNeeded
    {
        get
        {
            lock (_guard) return _jogs.Count > 0;
        }
    }

    /// <summary>A key is pressed: signals are required until the jog is disposed.</summary>
    public ContinuousJog BeginJog(JogVelocity velocity)
    {
        var jog = new ContinuousJog(new JogControl(velocity), End);
        lock (_guard)
        {
            _jogs.Add(jog);
            _lastSign = _lastCheck = time.GetTimestamp();
            _watch ??= time.CreateTimer(_ => CheckSigns(), null, SignInterval, SignInterval);
        }

        changed();
        return jog;
    }

    /// <summary>Signals that the front end is responsive and has the focus.</summary>
    public void Sign()
    {
        lock (_guard) _lastSign = time.GetTimestamp();
    }

    /// <summary>The operator has left: releases every jog. The stop is sent on this thread without waiting for the reply.</summary>
    public void ReleaseAll()
    {
        foreach (var jog in Jogs()) jog.Abandon(isLate: false);
    }

    private void CheckSigns()
    {
        lock (_guard)
        {
            var isHeldUp = time.GetElapsedTime(_lastCheck) > 2 * SignInterval; // This process itself was delayed: pending signals may be processed right after this.
            _lastCheck = time.GetTimestamp();
            if (isHeldUp || time.GetElapsedTime(_lastSign) < s_timeout) return;
        }

        foreach (var jog in Jogs()) jog.Abandon(isLate: true);
    }

    private ContinuousJog[] Jogs()
    {
        lock (_guard) return [.. _jogs];
    }

    private void End(ContinuousJog jog)
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
