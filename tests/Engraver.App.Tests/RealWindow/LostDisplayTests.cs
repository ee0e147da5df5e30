using Engraver.App.Tests.Start;
using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The X server dies in the middle of a job: the desktop stops the machine immediately and reports the reason before it ends.</summary>
[Collection(DesktopCollection.Name)]
public sealed class LostDisplayTests
{
    private const string Drawing = "paper-001.dxf";
    private const byte ToolOn = 1;
    private const string Why = "The connection to the display was lost while the machine was moving. The machine was stopped.";

    [XServerFact]
    public async Task The_machine_stops_and_standard_error_and_the_journal_say_why()
    {
        using var state = new TemporaryDesktopFolder();
        await using var machine = await RealMachine.SwitchedOnAsync();
        machine.StartClock();
        using var desktop = new ShownDesktop(state.Path);
        desktop.EnterUntil(Drawing, "OPEN", Path.Combine(RepositoryFolder.Samples, Drawing));
        desktop.EnterUntil(Drawing + " - READY", "CNCCONNECT", machine.Address);
        desktop.EnterUntil(Drawing + " - MOVING", "CNCGOTO", "40,25");
        desktop.WaitForTitle(Drawing + " - NO ORIGIN");
        desktop.EnterUntil(Drawing + " - READY", "CNCZERO", "All");
        desktop.EnterUntil(Drawing + " - ARMED", "CNCARM", "Stream");
        desktop.EnterUntil(Drawing + " - RUNNING", "CNCRUN");
        await machine.RunUntilAsync(status => (status.Outputs & ToolOn) != 0 && machine.Place.A > 130 * RealMachine.Scale);
        desktop.LoseDisplay();

        await machine.RunUntilAsync(status => status is { IsMoving: false, Outputs: 0 });
        machine.StartClock();
        Assert.Equal(1, desktop.WaitForExit());
        Assert.Contains(desktop.Output, line => line.Contains("engraver-desktop: " + Why, StringComparison.Ordinal));
        var journal = Directory.GetFiles(desktop.Journals, "paper-001-*.jsonl").Order(StringComparer.Ordinal).Last();
        var end = File.ReadLines(journal).Last(line => line.Contains("\"kind\":\"end\"", StringComparison.Ordinal));
        Assert.Contains("\"outcome\":\"stopped\"", end, StringComparison.Ordinal);
        Assert.Contains(Why, end, StringComparison.Ordinal);
    }

    [XServerFact]
    public void A_desktop_at_rest_says_that_nothing_moved()
    {
        using var state = new TemporaryDesktopFolder();
        using var desktop = new ShownDesktop(state.Path);
        desktop.LoseDisplay();

        Assert.Equal(1, desktop.WaitForExit());
        Assert.Contains(desktop.Output, line => line.EndsWith("engraver-desktop: The connection to the display was lost; the program closes. No machine was moving.", StringComparison.Ordinal));
    }
}
