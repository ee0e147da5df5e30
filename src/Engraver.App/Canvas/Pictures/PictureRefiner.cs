using Avalonia.Threading;

namespace Engraver.App.Canvas.Pictures;

/// <summary>Decides when a picture is redrawn: while the view moves, the last picture is shown moved, and the requested one is drawn when the view is at
/// rest.</summary>
internal sealed class PictureRefiner
{
    private readonly PictureKeeper _keeper;
    private readonly DispatcherTimer _still = new() { Interval = TimeSpan.FromMilliseconds(40.0) };

    public PictureRefiner(PictureKeeper keeper)
    {
        _keeper = keeper;
        _still.Tick += (_, _) => StandStill();
    }

    /// <summary>Time without movement after which the view counts as being at rest.</summary>
    public TimeSpan Stillness
    {
        get => _still.Interval;
        set => _still.Interval = value;
    }

    /// <summary>The view moves: stops the picture that is being drawn.</summary>
    public void WaitForHand()
    {
        Rest();
        DrawSoon();
    }

    /// <summary>Draws the requested picture when the view is at rest; the first one of all immediately. A picture that is being drawn is finished first, so
    /// that steady changes (a running machine) cannot starve it.</summary>
    public void DrawSoon()
    {
        if (_keeper.IsDrawing) return;
        if (_keeper.HasPicture || _keeper.Content.Scene is null) _still.Start();
        else StandStill();
    }

    /// <summary>Draws the requested picture immediately.</summary>
    public void RefineNow()
    {
        Rest();
        if (_keeper.View.Size.Width > 0) _keeper.Refine(CancellationToken.None);
    }

    /// <summary>Stops drawing until another picture is requested.</summary>
    public void Rest()
    {
        _still.Stop();
        _keeper.Abandon();
    }

    private async void StandStill()
    {
        _still.Stop();
        if (_keeper.IsFresh || _keeper.IsDrawing || _keeper.View.Size.Width <= 0) return;
        if (await _keeper.RefineAsync() && !_keeper.IsFresh) DrawSoon();
    }
}
