using Engraver.Core.Machines.Moves;

namespace Engraver.Workbench.Machines;

/// <summary>Whether the operator's side of a continuous jog is there: the front end says again and again that it lives and is before the operator, and a
/// jog of which nobody hears is released from another thread. Any thread.</summary>
/// <remarks>A front end that hangs does not hear that a key is released; the dead-man in the controller hears only that this process lives.</remarks>
public sealed class OperatorPresence(TimeProvider time, Action changed)
{
    /// <summary>Signs are given this often.</summary>
    public static readonly TimeSpan Beat = TimeSpan.FromMilliseconds(50);

    private static readonly TimeSpan s_patience = TimeSpan.FromMilliseconds(300);
    private readonly Lock _guard = new();
    private readonly List<HeldJog> _jogs = [];
    private ITimer? _watch;
    private long _heard;
    private long _looked;

    /// <summary>A jog is under way or about to begin, which needs signs.</summary>
    public bool IsNeeded
    {
        get
        {
            lock (_guard) return _jogs.Count > 0;
        }
    }

    /// <summary>A key goes down: from now on signs are needed, until the jog is disposed of.</summary>
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

    /// <summary>The front end lives and is before the operator.</summary>
    public void Sign()
    {
        lock (_guard) _heard = time.GetTimestamp();
    }

    /// <summary>The operator has left: every jog is released. The brake is commanded on this thread; its answer is not waited for.</summary>
    public void Leave()
    {
        foreach (var jog in Jogs()) jog.Lose(isLate: false);
    }

    private void Look()
    {
        lock (_guard)
        {
            var isHeldUp = time.GetElapsedTime(_looked) > 2 * Beat; // this side was held up itself: what was said meanwhile may be heard right after it
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

/// <summary>One continuous jog: it lives as long as its key is held and the front end gives its signs (<see cref="OperatorPresence"/>). Any thread.</summary>
public sealed class HeldJog : IDisposable
{
    private readonly TaskCompletionSource<bool> _lost = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Action<HeldJog> _end;

    internal HeldJog(JogControl control, Action<HeldJog> end) => (Control, _end) = (control, end);

    /// <summary>The key is no longer held, whoever said so.</summary>
    public bool IsReleased => Control.Released.IsCompleted;

    /// <summary>Completes when the jog is released though nobody released the key: true because the front end was not heard, false because the operator
    /// left it.</summary>
    public Task<bool> Lost => _lost.Task;

    internal JogControl Control { get; }

    /// <summary>Another speed in the same direction.</summary>
    public void Steer(double mmPerMinute) => Control.Velocity = Control.Velocity.At(mmPerMinute);

    /// <summary>The key is released: the machine brakes. The brake is commanded on this thread; its answer is not waited for.</summary>
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
