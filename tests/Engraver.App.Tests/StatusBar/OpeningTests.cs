using System.Globalization;
using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.Tests.StatusBar;

[Collection(DesktopCollection.Name)]
public sealed class OpeningTests(DesktopFixture fixture)
{
    private const int Lines = 2000;

    /// <summary>The reader is blocked at its first report until the operator has looked and pressed Esc.</summary>
    [Fact]
    public Task Escape_ends_the_opening_of_a_large_drawing_and_the_old_one_stays() => fixture.WithOperator(here =>
    {
        here.Open("paper-001.dxf");
        var before = here.Commands.Document.Current;
        var file = Large();
        using var told = new ManualResetEventSlim();
        using var goOn = new ManualResetEventSlim();
        here.Commands.Progress.Changed += Hold;
        var opening = here.Desk.Queue.RunAsync("OPEN", file);
        var text = here.Find<TextBlock>("WorkText");
        here.Until(() => told.IsSet && text.IsEffectivelyVisible && text.Text is { Length: > 0 }); // its notification may still be on the way to the window
        Assert.Matches("^Reading: [0-9]{1,2} % ", text.Text);
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Desk.Queue.Cancelled.IsCompleted);
        goOn.Set();
        here.WaitUntilIdle();

        Assert.True(opening.IsCompletedSuccessfully);
        Assert.Same(before, here.Commands.Document.Current);
        Assert.False(here.Window.Model.Status.IsWorking);
        Assert.False(here.Find<TextBlock>("WorkText").IsEffectivelyVisible);
        here.Commands.Progress.Changed -= Hold;
        File.Delete(file);

        void Hold(object? sender, EventArgs e)
        {
            told.Set();
            goOn.Wait(TimeSpan.FromSeconds(60));
        }
    });

    [Fact]
    public Task The_progress_grows_to_the_end() => fixture.WithOperator(here =>
    {
        var file = Large();
        var told = new List<double>();
        here.Commands.Progress.Changed += (_, _) => told.Add(here.Commands.Progress.Fraction ?? 2.0);
        here.Enter("OPEN", file);

        Assert.Equal(Lines, here.Commands.Document.Current.Drawing!.Entities.Count);
        Assert.Equal(told.Order(), told);
        Assert.InRange(told.Count, 50, 105);
        Assert.Equal(2.0, told[^1]);
        Assert.InRange(told[^2], 0.95, 1.0);
        File.Delete(file);
    });

    private static string Large()
    {
        var file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".dxf");
        using var text = new StreamWriter(file);
        text.Write("0\nSECTION\n2\nENTITIES\n");
        for (var i = 0; i < Lines; i++) text.Write(string.Create(CultureInfo.InvariantCulture, $"0\nLINE\n8\n0\n10\n{i}\n20\n0\n11\n{i}.5\n21\n1\n"));
        text.Write("0\nENDSEC\n0\nEOF\n");
        return file;
    }
}
