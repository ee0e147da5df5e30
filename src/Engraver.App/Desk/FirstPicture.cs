using Engraver.Core.Drawings;

namespace Engraver.App.Desk;

/// <summary>Delays the derivations of a large drawing until its first picture is drawn, so that the picture has all cores.</summary>
/// <remarks>Any thread.</remarks>
internal sealed class FirstPicture(TimeProvider time)
{
    /// <summary>Number of entities from which on the picture takes long enough to be delayed noticeably.</summary>
    private const int Large = 50_000;

    /// <summary>Maximum wait for a picture: the window may be hidden or busy.</summary>
    private static readonly TimeSpan s_longest = TimeSpan.FromSeconds(2);

    private readonly Lock _guard = new();
    private Drawing? _shown;
    private Drawing? _awaited;
    private TaskCompletionSource _there = new(TaskCreationOptions.RunContinuationsAsynchronously);

    /// <summary>Completes when a picture of the drawing has been shown; fails with a <see cref="TimeoutException"/> if that takes too long.</summary>
    public Task Of(Drawing? drawing)
    {
        lock (_guard)
        {
            var isAwaited = drawing is { Entities.Count: >= Large } && !ReferenceEquals(drawing, _shown);
            if (!isAwaited && _awaited is not null) Await(null); // keeps no reference to a drawing that is gone
            if (!isAwaited) return Task.CompletedTask;
            if (!ReferenceEquals(drawing, _awaited)) Await(drawing);
            return _there.Task.WaitAsync(s_longest, time);
        }
    }

    /// <summary>The canvas shows a picture of this drawing; null: no drawing is open.</summary>
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
