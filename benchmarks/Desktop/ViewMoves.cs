using Engraver.App.Desk;
using Engraver.Core.Geometry;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Moves of the view, one before each frame, like those of an operator: to and fro by a hundredth of the height, in and out by a twentieth.</summary>
internal sealed class ViewMoves(DesktopModel desk)
{
    private const double ZoomedIn = 16.0;

    /// <summary>Frames before a movement turns back.</summary>
    private const int Turn = 30;

    public void Pan(int frame)
    {
        var height = desk.Session.View.Current.Height;
        desk.Session.View.PanBy(new Vector2D((frame / Turn % 2 == 0 ? 0.01 : -0.01) * height, 0.0));
    }

    public void Zoom(int frame) => desk.Session.View.ZoomAbout(desk.Session.View.Current.Centre, frame / 10 % 2 == 0 ? 1.05 : 1.0 / 1.05);

    /// <summary>Zooms in until single lines of a large drawing are visible.</summary>
    public void GoNear() => desk.Session.View.SetCentre(desk.Session.View.Current.Centre, desk.Session.View.Current.Height / ZoomedIn);
}
