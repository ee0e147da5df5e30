using Avalonia.Threading;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>A queue of one: a newer value replaces one that the user interface has not taken yet.</summary>
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

    /// <summary>Called when something else is queued after the value: the value keeps its place in the queue, and the next one gets its own.</summary>
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
