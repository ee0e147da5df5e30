using System.Globalization;
using Avalonia;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Canvas.Rasterising;

/// <summary>The pictures of docs/images/first-job.gif: from an open drawing to a finished part. With ENGRAVER_PICTURES they are stored in its folder
/// <c>frames</c>, from which docs/images/make builds the animation.</summary>
[Collection(DesktopCollection.Name)]
public sealed class MovingPictureTests(DesktopFixture fixture)
{
    private const double Step = 1.0 / 16;

    private static readonly string? s_folder = Environment.GetEnvironmentVariable("ENGRAVER_PICTURES");

    [Fact]
    public Task A_first_job_from_the_drawing_to_the_part() => fixture.WithOperator(here =>
    {
        var taken = new List<double>();
        here.Hands.Resize(new Size(1100, 700));
        here.Commands.Settings.Change(settings => settings.WithVariable("FILEDIA", 0));
        here.Open("nameplate.dxf");
        here.Show("Job");
        Take(here, taken, 0);
        here.Enter("CNCCONNECT", "sim:?speed=5");
        here.Enter("CNCARM", "Stream");
        Take(here, taken, 0);
        here.Click(here.Find<Avalonia.Controls.Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running);
        for (var fraction = Step; fraction < 1; fraction += Step)
        {
            var wanted = fraction;
            here.Until(() => here.Commands.Machine.Status is { State: not MachineState.Running } || here.Commands.Machine.Status.Progress?.Fraction >= wanted);
            if (here.Commands.Machine.Status is not { State: MachineState.Running, Progress.Fraction: var reached }) break;
            Take(here, taken, reached);
        }

        here.Until(() => here.Window.Model.Machine.State == "DONE");
        Take(here, taken, 1);

        Assert.InRange(taken.Count, 10, 19);
        Assert.Equal(taken.Order(), taken);
    });

    private static void Take(Operator here, List<double> taken, double fraction)
    {
        here.Until(() => here.Window.Canvas.IsUpToDate);
        here.Step();
        using var whole = new MemoryStream();
        here.Hands.CapturePng(whole);
        whole.Position = 0;
        using var pixels = PngFile.Read(whole);
        if (s_folder is not null)
        {
            using var picture = File.Create(Path.Combine(Directory.CreateDirectory(Path.Combine(s_folder, "frames")).FullName, string.Create(CultureInfo.InvariantCulture, $"{taken.Count:00}.png")));
            PngFile.WriteIndexed(picture, pixels);
        }

        taken.Add(fraction);
    }
}
