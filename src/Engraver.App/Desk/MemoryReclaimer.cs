using Avalonia.Threading;
using Engraver.Workbench.Documents;

namespace Engraver.App.Desk;

/// <summary>Collects the garbage that planning or closing a large drawing has left, after the derivation is delivered and the earlier pictures are gone.
/// Never while the machine moves, because a collection suspends all threads for a moment. UI thread only.</summary>
/// <param name="isMoving">True while the machine moves.</param>
/// <param name="later">Runs an action with a delay: the last picture of a closed drawing is still referenced at first.</param>
/// <param name="collect">Runs the collection; a parameter, so that a test can count.</param>
internal sealed class MemoryReclaimer(Func<bool> isMoving, Action<Action> later, Func<Task> collect)
{
    /// <summary>Minimum number of curves of a drawing for a collection.</summary>
    internal const int LargeDrawingCurves = 200_000;

    /// <summary>Delay after which the last picture of a closed drawing is gone.</summary>
    private static readonly TimeSpan s_collectDelay = TimeSpan.FromSeconds(1);

    private DerivedDocument _lastDerived = DerivedDocument.Nothing;
    private bool _isDue;
    private bool _isScheduled;

    /// <summary>No collection is due.</summary>
    public bool IsDone => !_isDue && LastCollection.IsCompleted;

    /// <summary>The last collection.</summary>
    internal Task LastCollection { get; private set; } = Task.CompletedTask;

    /// <summary>The instance for the desktop.</summary>
    public static MemoryReclaimer ForDesktop(Func<bool> isMoving) => new(isMoving, action => DispatcherTimer.RunOnce(action, s_collectDelay), CollectAllAsync);

    /// <summary>A compacting collection that returns free memory to the operating system.</summary>
    private static Task CollectAllAsync() => Task.Run(() => GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true));

    /// <summary>To be called after every change. A collection that is due while the machine moves is made when the machine is at rest.</summary>
    public void OnDerivedChanged(DerivedDocument current)
    {
        if (!ReferenceEquals(current, _lastDerived))
        {
            var (isLarge, wasLarge) = (IsLarge(current.State), IsLarge(_lastDerived.State));
            _isDue |= isLarge != wasLarge || (isLarge && current.State.Drawing!.FileName != _lastDerived.State.Drawing!.FileName); // not after each edit, because a collection takes a noticeable time
            _lastDerived = current;
        }

        if (!_isDue || _isScheduled || isMoving()) return;
        _isScheduled = true;
        later(() => LastCollection = CollectAsync());
    }

    private async Task CollectAsync()
    {
        _isScheduled = false;
        if (isMoving()) return; // the next call requests it again
        _isDue = false;
        await collect();
    }

    private static bool IsLarge(DocumentState state) => state.Drawing is { Parts.Count: >= LargeDrawingCurves };
}
