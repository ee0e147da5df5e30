namespace Engraver.Simulator.Protocol;

/// <summary>Commands whose decode time passes in real time, one after the other: one interpreter serves every link, and links take turns. All members are
/// called under the controller's lock.</summary>
/// <param name="each">Wall time of one command.</param>
internal sealed class DecodeQueue(TimeProvider time, TimeSpan each)
{
    private readonly Queue<(TimeSpan Due, Handle Handle)> _waiting = new();
    private readonly long _start = time.GetTimestamp();
    private TimeSpan _free;
    private bool _isReleasing;

    /// <summary>Wall time until the next command is executed, zero or less when it is late; null when no command waits.</summary>
    public TimeSpan? Remaining => _waiting.TryPeek(out var next) ? next.Due - time.GetElapsedTime(_start) : null;

    /// <summary>Adds the command that a handle has received. A command that was already waiting in its handle starts at the end of the one before, however
    /// late the timer is.</summary>
    public void Add(Handle handle)
    {
        var now = _isReleasing ? _free : time.GetElapsedTime(_start);
        _free = (_free > now ? _free : now) + each;
        _waiting.Enqueue((_free, handle));
    }

    /// <summary>Executes the commands whose time has passed.</summary>
    public void Release()
    {
        _isReleasing = true;
        while (Remaining <= TimeSpan.Zero) _waiting.Dequeue().Handle.Resume();
        _isReleasing = false;
    }
}
