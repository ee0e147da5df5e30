using Avalonia.Threading;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Canvas.Interaction;

/// <summary>Computes previews of a click on another thread while the cursor moves: one at a time, then the one for the current cursor position.</summary>
/// <param name="changed">Called on the UI thread when the preview to be shown has changed.</param>
internal sealed class GhostRunner(Action changed)
{
    private (GhostFunction Ghost, Point2D Place)? _requested;
    private bool _isBusy;

    /// <summary>The preview in drawing units; empty for none.</summary>
    public IReadOnlyList<Segment> Shown { get; private set; } = [];

    /// <param name="ghost">The preview function of the prompt; null if it has none.</param>
    /// <param name="place">The point that a click gives; null if the cursor has left the canvas.</param>
    public void Request(GhostFunction? ghost, Point2D? place)
    {
        if (ghost is null || place is not { } at)
        {
            _requested = null;
            Show([]);
            return;
        }

        if (_requested == (ghost, at)) return;
        if (_requested?.Ghost != ghost) Show([]);
        _requested = (ghost, at);
        if (!_isBusy) Start(ghost, at);
    }

    private void Start(GhostFunction ghost, Point2D place)
    {
        _isBusy = true;
        _ = Task.Run(() => ghost(place)).ContinueWith(done => Dispatcher.UIThread.Post(() => OnComputed(ghost, place, done)), TaskScheduler.Default);
    }

    private void OnComputed(GhostFunction ghost, Point2D place, Task<IReadOnlyList<Segment>> done)
    {
        _isBusy = false;
        if (_requested is not { } wanted) return;
        if (wanted.Ghost == ghost) Show(done.IsCompletedSuccessfully ? done.Result : []);
        if (wanted != (ghost, place)) Start(wanted.Ghost, wanted.Place);
    }

    private void Show(IReadOnlyList<Segment> ghost)
    {
        if (Shown.Count == 0 && ghost.Count == 0) return;
        Shown = ghost;
        changed();
    }
}
