using Engraver.App.Tests.Start;
using Engraver.Simulator;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>A day at the machine (docs/operating.md) in a real window, with real keys and mouse, on a separate simulated controller behind TCP: from
/// power-on to the second plate. The assertions are about motors and tool. Its pictures are stored.</summary>
/// <remarks>In the full run: the fast subset opens, arms and starts a job in a real window in <see cref="RealJobTests"/>, resumes in one in
/// <see cref="KilledDesktopTests"/>, and homes, jogs and sets origins on a window in memory.</remarks>
[Collection(DesktopCollection.Name)]
public sealed class OperatorSessionTests(DesktopFixture fixture)
{
    private const string Drawing = "paper-001.dxf";
    private const byte ToolOn = 1;
    private static readonly TimeSpan s_untilPressedAgain = TimeSpan.FromSeconds(10);

    [FullRunXServerFact]
    public async Task From_power_on_to_the_second_plate()
    {
        using var files = new TemporaryDesktopFolder();
        await using var machine = await RealMachine.SwitchedOnAsync();
        var profile = RealMachine.ProfileIn(files.Path);
        var at = await ControlPositions.OfAsync(fixture, profile);
        using var desktop = new ShownDesktop();
        machine.StartClock();

        // Power on, connect, home.
        var morning = Path.Combine(files.Path, "morning.scr");
        await File.WriteAllTextAsync(morning, $"CNCPROFILE\n{profile}\nOPEN\n{Path.Combine(RepositoryFolder.Samples, Drawing)}\n");
        desktop.EnterUntil(Drawing, "SCRIPT", morning);
        desktop.EnterUntil(Drawing + " - NOT HOMED", "CNCCONNECT", machine.Address);
        desktop.Click(at["Machine"]);
        desktop.Click(at["Alarms"]); // the history contains paths of this computer
        Keep(desktop, "day-1-not-homed");
        desktop.Click(at["Command"]);
        desktop.Click(at["HomeKey"]);
        desktop.Enter("Yes");
        desktop.WaitForTitle(Drawing + " - MOVING");
        desktop.WaitForTitle(Drawing + " - NO ORIGIN");

        // Moves to the corner of the plate: a held key of the pad, then steps; the position becomes the zero.
        desktop.Click(at["Step Continuous"]);
        await HoldAsync(desktop, machine, at["Pad X+"], place => place.A > 20 * RealMachine.Scale);
        await HoldAsync(desktop, machine, at["Pad Y+"], place => place.B > 15 * RealMachine.Scale);
        desktop.Click(at["Step 1"]);
        var before = machine.Place;
        desktop.Click(at["Pad X+"]);
        desktop.WaitForTitle(Drawing + " - MOVING");
        desktop.WaitForTitle(Drawing + " - NO ORIGIN");
        Assert.Equal((before.A + RealMachine.Scale, before.B), machine.Place);
        Keep(desktop, "day-2-at-the-corner");
        desktop.Settle();
        desktop.ClickUntil(at["ZeroAllKey"], Drawing + " - READY");
        var corner = machine.Place;

        // Frame around the work piece, then a dry run.
        desktop.EnterUntil(Drawing + " - MOVING", "CNCFRAME", "Rectangle");
        desktop.WaitForTitle(Drawing + " - READY");
        desktop.EnterUntil(Drawing + " - ARMED", "CNCARM", "Dryrun", "Stream");
        desktop.ClickUntil(at["StartKey"], Drawing + " - DRY RUN");
        await machine.RunUntilAsync(status => status.IsMoving && machine.Place.A > corner.A + (60 * RealMachine.Scale));
        Keep(desktop, "day-3-dry-run");
        machine.StartClock();
        desktop.WaitForTitle(Drawing + " - DONE");
        Assert.All(Rows(machine, 0), row => Assert.Equal(0, row.Outputs & ToolOn));

        // The job: held and continued with another feed, stopped, resumed.
        desktop.Click(at["Job"]);
        desktop.ClickUntil(at["ArmKey"], Drawing + " - ARMED");
        Keep(desktop, "day-4-armed");
        var began = (int)machine.Controller.Record.Count;
        desktop.ClickUntil(at["StartKey"], Drawing + " - RUNNING");
        using (var way = new CutLength(machine, ToolOn)) await machine.RunUntilAsync(status => (status.Outputs & ToolOn) != 0 && way.Counts > 30 * RealMachine.Scale);
        Keep(desktop, "day-5-running");
        desktop.Press("Escape");
        machine.StartClock();
        desktop.WaitForTitle(Drawing + " - HELD");
        Assert.Equal(0, machine.Controller.Status.Outputs & ToolOn);
        desktop.Click(at["SlowerKey"]);
        desktop.Click(at["SlowerKey"]);
        Keep(desktop, "day-6-held");
        desktop.ClickUntil(at["StartKey"], Drawing + " - RUNNING");
        var resumed = (int)machine.Controller.Record.Count;
        using (var way = new CutLength(machine, ToolOn)) await machine.RunUntilAsync(_ => way.Counts > 60 * RealMachine.Scale);
        Assert.InRange(FastestCut(machine, resumed), 0.5, 0.95); // slower than the feed of the profile
        desktop.Press("Pause");
        machine.StartClock();
        desktop.WaitForTitle(Drawing + " - STOPPED");
        Assert.Equal(0, machine.Controller.Status.Outputs & ToolOn);
        desktop.Click(at["Alarms"]);
        Keep(desktop, "day-7-stopped");
        desktop.Click(at["Command"]);
        desktop.Settle();
        desktop.Enter("CNCRESUME", "");
        desktop.Settle();
        desktop.ClickUntil(at["ArmKey"], Drawing + " - ARMED");
        desktop.ClickUntil(at["StartKey"], Drawing + " - RUNNING");
        desktop.WaitForTitle(Drawing + " - DONE");
        Keep(desktop, "day-8-done");
        var first = PathOf(machine, began, corner);
        AssertWhole(first);

        // The second plate, in another fixture.
        desktop.EnterUntil(Drawing + " - NO ORIGIN", "CNCOVERRIDE", "100", "CNCORIGIN", "G55");
        desktop.EnterUntil(Drawing + " - MOVING", "CNCGOTO", "150,60");
        await machine.RunUntilAsync(status => status.IsIdle && machine.Place == (150 * RealMachine.Scale, 60 * RealMachine.Scale));
        machine.StartClock();
        desktop.EnterUntil(Drawing + " - READY", "CNCZERO", "All");
        var second = (int)machine.Controller.Record.Count;
        desktop.ClickUntil(at["ArmKey"], Drawing + " - ARMED");
        desktop.Click(at["StartKey"]);
        desktop.WaitForTitle(Drawing + " - DONE");
        Keep(desktop, "day-9-second-plate");
        AssertWhole(PathOf(machine, second, (150 * RealMachine.Scale, 60 * RealMachine.Scale)));
        Assert.Equal(0, desktop.Close());
    }

    /// <summary>Holds a key of the pad until the machine has reached a position. If this computer is too busy to receive the press, or if the window does
    /// not respond for 0.3 s (which releases the jog), the operator presses again.</summary>
    private static async Task HoldAsync(ShownDesktop desktop, RealMachine machine, Avalonia.Point key, Func<(int A, int B), bool> far)
    {
        for (var tries = 0; tries < 20 && !far(machine.Place); tries++)
        {
            var before = machine.Place;
            desktop.HoldDown(key);
            try
            {
                await machine.RunUntilAsync(_ => machine.Place != before, s_untilPressedAgain);
            }
            catch (TimeoutException)
            {
                desktop.LetGo(); // the press was not received
                desktop.Settle();
                continue;
            }

            await machine.RunUntilAsync(status => !status.IsMoving || far(machine.Place));
            desktop.LetGo();
            machine.StartClock();
            desktop.WaitForTitle(Drawing + " - MOVING");
            desktop.WaitForTitle(Drawing + " - NO ORIGIN");
        }

        Assert.True(far(machine.Place));
    }

    private static IEnumerable<MotionSample> Rows(RealMachine machine, int from) => machine.Controller.Record.Snapshot().Skip(from);

    /// <summary>The fastest sample with the tool on, as a fraction of the profile's feed.</summary>
    private static double FastestCut(RealMachine machine, int from)
    {
        var rows = Rows(machine, from).ToList();
        var fastest = rows.Zip(rows.Skip(1)).Where(pair => (pair.Second.Outputs & ToolOn) != 0).Max(pair => double.Hypot(pair.Second.A - pair.First.A, pair.Second.B - pair.First.B) / Math.Max(1, pair.Second.Sample - pair.First.Sample));
        return fastest * 60.0 / Core.Machines.MachineProfile.Default.FeedMmPerMinute;
    }

    /// <summary>Positions with the tool on, counts from a zero.</summary>
    private static List<(int X, int Y)> PathOf(RealMachine machine, int from, (int A, int B) zero) => [.. Rows(machine, from).Where(row => (row.Outputs & ToolOn) != 0).Select(row => (row.A - zero.A, row.B - zero.B))];

    /// <summary>The part of the sample: 100 by 150 mm, 50 mm right of its zero and above it.</summary>
    private static void AssertWhole(List<(int X, int Y)> path)
    {
        Assert.Equal((100 * RealMachine.Scale, 150 * RealMachine.Scale), (path.Max(place => place.X) - path.Min(place => place.X), path.Max(place => place.Y) - path.Min(place => place.Y)));
        Assert.Equal((50 * RealMachine.Scale, 50 * RealMachine.Scale), (path.Min(place => place.X), path.Min(place => place.Y)));
    }

    private static void Keep(ShownDesktop desktop, string name)
    {
        var picture = desktop.Picture();
        Assert.InRange(picture.Length, 10_000, 200_000);
        File.WriteAllBytes(Path.Combine(ShownDesktop.Pictures, name + ".png"), picture);
    }
}
