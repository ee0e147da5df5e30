using Engraver.Core.Drawings;

namespace Engraver.App.Desk;

/// <summary>The first picture of a large drawing has the computer to itself: what follows from the drawing is computed behind it.</summary>
/// <remarks>Any thread.</remarks>
internal sealed class FirstPicture(TimeProvider time)
{
    /// <summary>Entities from which on the picture of a drawing takes long enough to be disturbed.</summary>
    private const int Large = 50_000;

    /// <summary>A picture that is not there by then (nobody looks, or the window is busy) is not waited for.</summary>
    private static readonly TimeSpan s_longest = TimeSpan.FromSeconds(2);

    private readonly Lock _guard = new();
    private Drawing? _shown;
    private Drawing? _awaited;
    private TaskCompletionSource _there = new(TaskCreationOptions.RunContinuationsAsynchronously);

    /// <summary>Completes when a picture of the drawing was there; fails with a <see cref="TimeoutException"/> when that takes too long.</summary>
    public Task Of(Drawing? drawing)
    {
        lock (_guard)
        {
            var isAwaited = drawing is { Entities.Count: >= Large } && !ReferenceEquals(drawing, _shown);
            if (!isAwaited && _awaited is not null) Await(null); // a drawing that is gone is not held
            if (!isAwaited) return Task.CompletedTask;
            if (!ReferenceEquals(drawing, _awaited)) Await(drawing);
            return _there.Task.WaitAsync(s_longest, time);
        }
    }

    /// <summary>The canvas shows a picture of this drawing, or that there is none.</summary>
    public void Show(Drawing? drawing)
    {
        lock (_guard)
        {
            _shown = drawing;
            if (ReferenceEquals(drawing, _awaited)) Await(null);
        }
    }

    private void Await(Drawing? drawing)
    {
        _there.TrySetResult();
        (_awaited, _there) = (drawing, new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously));
    }
}
