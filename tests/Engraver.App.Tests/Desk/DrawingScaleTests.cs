using Engraver.App.Canvas.Overlays;
using Engraver.App.Desk;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.App.Tests.Desk;

/// <summary>CNCUNITS is for the next OPEN: what is drawn over the drawing that is open keeps its scale.</summary>
[Collection(DesktopCollection.Name)]
public sealed class DrawingScaleTests(DesktopFixture fixture)
{
    private const int Millimetres = 4;

    [Fact]
    public Task Overlays_machine_and_playback_stay_where_they_are_when_the_unit_of_the_next_drawing_is_set() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf"); // inches
        here.Enter("CNCCONNECT", "sim:?speed=5", "CNCZERO", "All", "CNCJOG", "25.4,50.8");
        here.Until(() => here.Window.Canvas.Machine!.Place.DistanceTo(new Point2D(1.0, 2.0)) < 0.001);
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 3;
        here.Step();
        var (machine, playback, overlay) = (here.Window.Canvas.Machine!.Place, here.Window.Canvas.PlaybackPosition!.Value, Overlay(here));

        here.Enter("CNCUNITS", $"{Millimetres}");
        here.Until(() => !ReferenceEquals(Overlay(here), overlay));
        here.Window.Model.Playback.At = here.Window.Model.Playback.Total / 3;
        here.Step();

        Assert.Equal(machine, here.Window.Canvas.Machine!.Place);
        Assert.Equal(playback, here.Window.Canvas.PlaybackPosition!.Value);
        Assert.Equal(overlay.StartMarks.Select(mark => mark.Place), Overlay(here).StartMarks.Select(mark => mark.Place));
        Assert.Equal(overlay.Rapids.Bounds, Overlay(here).Rapids.Bounds);
        Assert.Equal(overlay.CutPath.Bounds, Overlay(here).CutPath.Bounds);
    });

    /// <summary>A table of 254 x 508 mm, the drawing's zero in its corner.</summary>
    [Fact]
    public Task The_envelope_of_the_machine_is_in_units_of_the_drawing() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCUNITS", $"{Millimetres}");
        var job = here.Desk.Derived.Job!;
        var axes = job.Settings.Machine.Axes;
        var table = job.Settings.Machine with { Axes = axes with { X = axes.X with { Travel = new AxisTravel(0.0, 254.0) }, Y = axes.Y with { Travel = new AxisTravel(0.0, 508.0) } } };

        var inputs = new MachineOverlay(job with { Settings = job.Settings with { Machine = table } }, Point2D.Origin, null, default).ApplyTo(OverlayInputs.None);
        Assert.Equal(new Bounds2D(0.0, 0.0, 10.0, 20.0), inputs.MachineEnvelope);
    });

    [Fact]
    public Task The_place_of_a_finding_stays_where_it_is() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        var finding = SequencingRules.SmallGap.At(default, "1", "2", "3") with { Place = new Point2D(25.4, 50.8) };
        here.Desk.ShowPlaceOf(finding);
        Assert.Equal(new Point2D(1.0, 2.0), here.Commands.View.Current.Focus!.Place);
        here.Enter("CNCUNITS", $"{Millimetres}");
        here.Desk.ShowPlaceOf(finding);
        Assert.Equal(new Point2D(1.0, 2.0), here.Commands.View.Current.Focus!.Place);
    });

    private static OverlayScene Overlay(Operator here) => here.Window.Canvas.Overlay!;
}
