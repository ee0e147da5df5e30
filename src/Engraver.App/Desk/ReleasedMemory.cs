using Avalonia.Threading;
using Engraver.Workbench.Documents;

namespace Engraver.App.Desk;

/// <summary>Gives back the memory that planning or closing a large drawing has left, once what followed from it is delivered and the pictures of what was
/// before are gone. Never while anything of the machine moves: a collection stops every thread for a moment. UI thread only.</summary>
/// <param name="isMoving">True while the machine moves.</param>
/// <param name="later">Runs an action a moment later: at once the last picture of a closed drawing would still be held.</param>
/// <param name="collect">Collects everything; a parameter, so that a test can count.</param>
internal sealed class ReleasedMemory(Func<bool> isMoving, Action<Action> later, Func<Task> collect)
{
    /// <summary>Curves of a drawing from which on it is worth a collection.</summary>
    internal const int LargeDrawing = 200_000;

    /// <summary>By then the last picture of a closed drawing is gone.</summary>
    private static readonly TimeSpan s_pictureGone = TimeSpan.FromSeconds(1);

    private DerivedDocument _seen = DerivedDocument.Nothing;
    private bool _isDue;
    private bool _isAskedFor;

    /// <summary>Nothing large waits to be given back.</summary>
    public bool IsDone => !_isDue && Collecting.IsCompleted;

    /// <summary>The last collection.</summary>
    internal Task Collecting { get; private set; } = Task.CompletedTask;

    /// <summary>For the desktop.</summary>
    public static ReleasedMemory OfDesktop(Func<bool> isMoving) => new(isMoving, action => DispatcherTimer.RunOnce(action, s_pictureGone), CollectAllAsync);

    /// <summary>The collection of the runtime: compacting, and what is free goes back to the computer.</summary>
    private static Task CollectAllAsync() => Task.Run(() => GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true));

    /// <summary>Something has changed. A collection that may not be now is made up for when the machine rests.</summary>
    public void Look(DerivedDocument current)
    {
        if (!ReferenceEquals(current, _seen))
        {
            var (isLarge, wasLarge) = (IsLarge(current.State), IsLarge(_seen.State));
            _isDue |= isLarge != wasLarge || (isLarge && current.State.Drawing!.FileName != _seen.State.Drawing!.FileName); // not after each edit: it takes moments
            _seen = current;
        }

        if (!_isDue || _isAskedFor || isMoving()) return;
        _isAskedFor = true;
        later(() => Collecting = CollectAsync());
    }

    private async Task CollectAsync()
    {
        _isAskedFor = false;
        if (isMoving()) return; // the next look asks again
        _isDue = false;
        await collect();
    }

    private static bool IsLarge(DocumentState state) => state.Drawing is { Parts.Count: >= LargeDrawing };
}
