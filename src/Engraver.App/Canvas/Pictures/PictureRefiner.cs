using Avalonia.Threading;

namespace Engraver.App.Canvas.Pictures;

/// <summary>When a picture is drawn anew: while the hand moves the last one is shown moved, and the wanted one is drawn once the hand is still.</summary>
internal sealed class PictureRefiner
{
    private readonly PictureKeeper _keeper;
    private readonly DispatcherTimer _still = new() { Interval = TimeSpan.FromMilliseconds(40.0) };

    public PictureRefiner(PictureKeeper keeper)
    {
        _keeper = keeper;
        _still.Tick += (_, _) => StandStill();
    }

    /// <summary>How long nothing must move until the hand counts as still.</summary>
    public TimeSpan Stillness
    {
        get => _still.Interval;
        set => _still.Interval = value;
    }

    /// <summary>The view moves: what is being drawn is wanted no longer.</summary>
    public void WaitForHand()
    {
        Rest();
        DrawSoon();
    }

    /// <summary>Nothing to wait for before the first picture; a picture that is being drawn is finished first, so that steady changes (a running machine) cannot starve it.</summary>
    public void DrawSoon()
    {
        if (_keeper.IsDrawing) return;
        if (_keeper.HasPicture || _keeper.Content.Scene is null) _still.Start();
        else StandStill();
    }

    /// <summary>Draws the wanted picture now.</summary>
    public void RefineNow()
    {
        Rest();
        if (_keeper.View.Size.Width > 0) _keeper.Refine(CancellationToken.None);
    }

    /// <summary>Draws nothing until something is wanted again.</summary>
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
