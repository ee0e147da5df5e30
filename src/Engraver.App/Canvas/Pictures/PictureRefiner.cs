using Avalonia.Threading;

namespace Engraver.App.Canvas.Pictures;

/// <summary>Decides when a picture is redrawn: while the view moves, the last picture is shown moved, and the requested one is drawn when the view is at
/// rest.</summary>
internal sealed class PictureRefiner
{
    private readonly PictureCache _cache;
    private readonly DispatcherTimer _restTimer = new() { Interval = TimeSpan.FromMilliseconds(40.0) };

    public PictureRefiner(PictureCache keeper)
    {
        _cache = keeper;
        _restTimer.Tick += (_, _) => OnViewAtRest();
    }

    /// <summary>Time without movement after which the view counts as being at rest.</summary>
    public TimeSpan RestDelay
    {
        get => _restTimer.Interval;
        set => _restTimer.Interval = value;
    }

    /// <summary>The view moves: stops the picture that is being drawn.</summary>
    public void OnViewMoving()
    {
        Stop();
        RefineSoon();
    }

    /// <summary>Draws the requested picture when the view is at rest; the first one of all immediately. A picture that is being drawn is finished first, so
    /// that steady changes (a running machine) cannot starve it.</summary>
    public void RefineSoon()
    {
        if (_cache.IsDrawing) return;
        if (_cache.HasPicture || _cache.Content.Scene is null) _restTimer.Start();
        else OnViewAtRest();
    }

    /// <summary>Draws the requested picture immediately.</summary>
    public void RefineNow()
    {
        Stop();
        if (_cache.View.Size.Width > 0) _cache.Refine(CancellationToken.None);
    }

    /// <summary>Stops drawing until another picture is requested.</summary>
    public void Stop()
    {
        _restTimer.Stop();
        _cache.CancelDrawing();
    }

    private async void OnViewAtRest()
    {
        _restTimer.Stop();
        if (_cache.IsUpToDate || _cache.IsDrawing || _cache.View.Size.Width <= 0) return;
        if (await _cache.RefineAsync() && !_cache.IsUpToDate) RefineSoon();
    }
}
