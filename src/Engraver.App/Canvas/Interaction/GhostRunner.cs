using Avalonia.Threading;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas.Interaction;

/// <summary>Works out what a click would give, beside the hand that moves the cursor: one ghost at a time on another thread, then the one for where the
/// cursor is by then.</summary>
/// <param name="changed">Called on the thread of the desktop when another ghost is to be seen.</param>
internal sealed class GhostRunner(Action changed)
{
    private (GhostOf Ghost, Point2D Place)? _wanted;
    private bool _isBusy;

    /// <summary>The ghost in drawing units; empty for none.</summary>
    public IReadOnlyList<Segment> Shown { get; private set; } = [];

    /// <param name="ghost">Of the command that asks; null when it has none.</param>
    /// <param name="place">The place that a click gives; null when the cursor has left.</param>
    public void Want(GhostOf? ghost, Point2D? place)
    {
        if (ghost is null || place is not { } at)
        {
            _wanted = null;
            Show([]);
            return;
        }

        if (_wanted == (ghost, at)) return;
        if (_wanted?.Ghost != ghost) Show([]);
        _wanted = (ghost, at);
        if (!_isBusy) Begin(ghost, at);
    }

    private void Begin(GhostOf ghost, Point2D place)
    {
        _isBusy = true;
        _ = Task.Run(() => ghost(place)).ContinueWith(done => Dispatcher.UIThread.Post(() => Take(ghost, place, done)), TaskScheduler.Default);
    }

    private void Take(GhostOf ghost, Point2D place, Task<IReadOnlyList<Segment>> done)
    {
        _isBusy = false;
        if (_wanted is not { } wanted) return;
        if (wanted.Ghost == ghost) Show(done.IsCompletedSuccessfully ? done.Result : []);
        if (wanted != (ghost, place)) Begin(wanted.Ghost, wanted.Place);
    }

    private void Show(IReadOnlyList<Segment> ghost)
    {
        if (Shown.Count == 0 && ghost.Count == 0) return;
        Shown = ghost;
        changed();
    }
}
