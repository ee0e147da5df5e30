using Engraver.Core.Drawings;

namespace Engraver.App.Desk;

/// <summary>Delays the derivations of a large drawing until its first picture is drawn, so that the picture has all cores.</summary>
/// <remarks>Any thread.</remarks>
internal sealed class FirstPictureGate(TimeProvider time)
{
    /// <summary>Number of entities from which on the picture takes long enough to be delayed noticeably.</summary>
    private const int LargeDrawingEntities = 50_000;

    /// <summary>Maximum wait for a picture: the window may be hidden or busy.</summary>
    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(2);

    private readonly Lock _guard = new();
    private Drawing? _shown;
    private Drawing? _awaited;
    private TaskCompletionSource _shownSource = new(TaskCreationOptions.RunContinuationsAsynchronously);

    /// <summary>Completes when a picture of the drawing has been shown; fails with a <see cref="TimeoutException"/> if that takes too long.</summary>
    public Task WhenShown(Drawing? drawing)
    {
        lock (_guard)
        {
            var isAwaited = drawing is { Entities.Count: >= LargeDrawingEntities } && !ReferenceEquals(drawing, _shown);
            if (!isAwaited && _awaited is not null) Expect(null); // keeps no reference to a drawing that is gone
            if (!isAwaited) return Task.CompletedTask;
            if (!ReferenceEquals(drawing, _awaited)) Expect(drawing);
            return _shownSource.Task.WaitAsync(s_timeout, time);
        }
    }

    /// <summary>The canvas shows a picture of this drawing; null: no drawing is open.</summary>
    public void OnShown(Drawing? drawing)
    {
        lock (_guard)
        {
            _shown = drawing;
            if (ReferenceEquals(drawing, _awaited)) Expect(null);
        }
    }

    private void Expect(Drawing? drawing)
    {
        _shownSource.TrySetResult();
        (_awaited, _shownSource) = (drawing, new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously));
    }
}
