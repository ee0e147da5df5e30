using Engraver.Workbench.Documents;

namespace Engraver.App.Desk;

/// <summary>Gives back the memory that planning or closing a large drawing has left, once what followed from it is delivered. Never while anything of the machine moves: a collection stops every thread for a moment.</summary>
/// <param name="isMoving">Asked on the UI thread.</param>
/// <param name="collect">Collects everything; a parameter, so that a test can count.</param>
internal sealed class ReleasedMemory(Func<bool> isMoving, Action collect)
{
    /// <summary>Curves of a drawing from which on it is worth a collection.</summary>
    internal const int LargeDrawing = 200_000;

    private DerivedDocument _seen = DerivedDocument.Nothing;

    /// <summary>The collection of the runtime: compacting, and what is free goes back to the computer.</summary>
    public static void CollectAll() => _ = Task.Run(() => GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true));

    /// <summary>Something has changed. A collection that may not be now is made up for when the machine rests.</summary>
    public void Look(DerivedDocument current)
    {
        if (ReferenceEquals(current, _seen) || isMoving()) return;
        var (isLarge, wasLarge) = (IsLarge(current.State), IsLarge(_seen.State));
        var isOther = isLarge != wasLarge || (isLarge && current.State.Drawing!.FileName != _seen.State.Drawing!.FileName); // not after each edit: it takes moments
        _seen = current;
        if (isOther) collect();
    }

    private static bool IsLarge(DocumentState state) => state.Drawing is { Parts.Count: >= LargeDrawing };
}
