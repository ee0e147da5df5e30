using Avalonia.Threading;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A queue of one: while the user interface has not taken a value yet, a newer one replaces it.</summary>
internal sealed class LatestOnly<T>(Action<T> taken)
    where T : struct
{
    private readonly Lock _gate = new();
    private Waiting? _waiting;

    public void Put(T value)
    {
        lock (_gate)
        {
            if (_waiting is not null)
            {
                _waiting.Value = value;
                return;
            }

            var waiting = _waiting = new Waiting { Value = value };
            Dispatcher.UIThread.Post(() => Take(waiting), DispatcherPriority.Input);
        }
    }

    /// <summary>Something else is queued after the value: it keeps its place, and the next one gets its own.</summary>
    public void Seal()
    {
        lock (_gate) _waiting = null;
    }

    private void Take(Waiting waiting)
    {
        T value;
        lock (_gate)
        {
            value = waiting.Value;
            if (_waiting == waiting) _waiting = null;
        }

        taken(value);
    }

    private sealed class Waiting
    {
        public T Value { get; set; }
    }
}
