using Engraver.App.Tests.Start;
using Engraver.SoftwarePlatform.Tests.X11;
using Engraver.TestKit;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The desktop's process dies in the middle of a job, with its machine in another process: the machine stops automatically, and a desktop that is
/// started afterwards restores what it can.</summary>
[Collection(DesktopCollection.Name)]
public sealed class KilledDesktopTests(DesktopFixture fixture)
{
    private const string Drawing = "paper-001.dxf";
    private const byte ToolOn = 1;

    /// <summary>The lower left corner of the part, both axes, counts from the drawing's zero.</summary>
    private const int Corner = 50 * RealMachine.Scale;

    /// <summary>The watchdog trips 1.0 s after the last heartbeat (galil-dmc.md EX12), and the axes brake.</summary>
    private const int LongestTail = 1400;

    [XServerFact]
    public async Task A_desktop_killed_in_mid_job_leaves_a_machine_that_stops_and_the_next_one_goes_on_at_its_place()
    {
        using var files = new TemporaryDesktopFolder();
        using var state = new TemporaryDesktopFolder();
        await using var machine = await RealMachine.SwitchedOnAsync();
        var at = await ControlPositions.OfAsync(fixture, RealMachine.ProfileIn(files.Path));
        var zero = (A: 40 * RealMachine.Scale, B: 25 * RealMachine.Scale);
        machine.StartClock();
        long killed;
        using (var desktop = new ShownDesktop(state.Path))
        {
            Begin(desktop, machine, "READY");
            desktop.EnterUntil(Drawing + " - MOVING", "CNCGOTO", "40,25");
            desktop.WaitForTitle(Drawing + " - NO ORIGIN");
            desktop.EnterUntil(Drawing + " - READY", "CNCZERO", "All");
            desktop.ClickUntil(at["ArmKey"], Drawing + " - ARMED");
            desktop.ClickUntil(at["StartKey"], Drawing + " - RUNNING");
            await machine.RunUntilAsync(status => (status.Outputs & ToolOn) != 0 && machine.Place.A > zero.A + (90 * RealMachine.Scale));
            killed = machine.Controller.Status.Sample;
            desktop.Kill();
        }

        var stopped = await machine.RunUntilAsync(status => status is { IsMoving: false, Outputs: 0 });
        machine.StartClock();
        var tail = machine.Controller.Record.Snapshot().Where(row => row.Sample > killed).ToList();
        Assert.InRange(tail[^1].Sample - killed, 0, LongestTail);
        Assert.Equal(0, stopped.Outputs);

        using (var desktop = new ShownDesktop(state.Path))
        {
            Begin(desktop, machine, "READY"); // the controller was on all the time: it counts from the same zero, and reports so
            var journal = Directory.GetFiles(desktop.Journals, "paper-001-*.jsonl").Order(StringComparer.Ordinal).Last();
            desktop.Settle();
            desktop.Enter("CNCRESUME", journal);
            desktop.Settle();
            desktop.ClickUntil(at["ArmKey"], Drawing + " - ARMED");
            desktop.ClickUntil(at["StartKey"], Drawing + " - RUNNING");
            desktop.WaitForTitle(Drawing + " - DONE");
            File.WriteAllBytes(Path.Combine(ShownDesktop.Pictures, "killed-and-resumed.png"), desktop.Picture());
            Assert.Equal(0, desktop.Close());
        }

        var cut = machine.Controller.Record.Snapshot().Where(row => (row.Outputs & ToolOn) != 0).Select(row => (X: row.A - zero.A - Corner, Y: row.B - zero.B - Corner)).ToList();
        Assert.Equal((0, 0, 100 * RealMachine.Scale, 150 * RealMachine.Scale), (cut.Min(place => place.X), cut.Min(place => place.Y), cut.Max(place => place.X), cut.Max(place => place.Y)));
        Assert.All(cut, place => Assert.True(DistanceFromPart(place.X, place.Y) <= 9.0, $"{place} is not on the part")); // corners are rounded within 10 counts, 7 from the nearer side
        Assert.InRange(LongestGap(cut), 0.0, 200.0);
    }

    /// <summary>The same, and the controller is switched off before the next desktop starts: its position is lost, and a job is refused with an
    /// instruction. In the full run: <c>ResumeAfterPowerTests</c> tests in the session that a power cycle is detected, and <c>WorkOriginTests</c> without
    /// homing.</summary>
    [FullRunXServerFact]
    public async Task After_a_power_cycle_the_next_desktop_refuses_until_the_zero_is_set_again()
    {
        using var state = new TemporaryDesktopFolder();
        await using (var machine = await RealMachine.SwitchedOnAsync())
        {
            machine.StartClock();
            using var desktop = new ShownDesktop(state.Path);
            Begin(desktop, machine, "READY");
            desktop.EnterUntil(Drawing + " - MOVING", "CNCGOTO", "40,25");
            desktop.WaitForTitle(Drawing + " - NO ORIGIN");
            desktop.EnterUntil(Drawing + " - READY", "CNCZERO", "All");
            desktop.EnterUntil(Drawing + " - ARMED", "CNCARM", "Stream");
            desktop.EnterUntil(Drawing + " - RUNNING", "CNCRUN");
            await machine.RunUntilAsync(status => (status.Outputs & ToolOn) != 0 && machine.Place.A > 130 * RealMachine.Scale);
            desktop.Kill();
        }

        await using var again = await RealMachine.SwitchedOnAsync();
        again.StartClock();
        using var next = new ShownDesktop(state.Path);
        Begin(next, again, "NO ORIGIN");
        next.Settle();
        next.Enter("CNCARM", "Stream");
        next.Settle();
        next.Enter("CNCRUN");
        File.WriteAllBytes(Path.Combine(ShownDesktop.Pictures, "killed-and-off.png"), next.Picture());
        Assert.Equal(0, next.Close());
        Assert.DoesNotContain(next.Titles, title => title.Contains("ARMED", StringComparison.Ordinal) || title.Contains("RUNNING", StringComparison.Ordinal));
        Assert.DoesNotContain(again.Controller.Record.Snapshot(), row => row.Outputs != 0);
    }

    /// <param name="state">The expected state of the connected machine.</param>
    private static void Begin(ShownDesktop desktop, RealMachine machine, string state)
    {
        desktop.EnterUntil(Drawing, "OPEN", Path.Combine(RepositoryFolder.Samples, Drawing));
        desktop.EnterUntil(Drawing + " - " + state, "CNCCONNECT", machine.Address);
    }

    /// <summary>Distance from the part of the sample, counts: a rectangle of 100 by 100 mm with a half circle above it.</summary>
    private static double DistanceFromPart(double x, double y)
    {
        var (side, radius) = (100.0 * RealMachine.Scale, 50.0 * RealMachine.Scale);
        return y >= side ? Math.Abs(double.Hypot(x - radius, y - side) - radius) : Math.Min(Math.Abs(y), Math.Min(Math.Abs(x), Math.Abs(x - side)));
    }

    /// <summary>The longest uncut stretch along the part, counts, by the angle from its middle.</summary>
    private static double LongestGap(List<(int X, int Y)> cut)
    {
        var (middleX, middleY) = (50.0 * RealMachine.Scale, 75.0 * RealMachine.Scale);
        var angles = cut.Select(place => Math.Atan2(place.Y - middleY, place.X - middleX)).Order().ToList();
        var widest = angles.Zip(angles.Skip(1)).Select(pair => pair.Second - pair.First).Append(angles[0] + (2.0 * Math.PI) - angles[^1]).Max();
        return widest * 90.0 * RealMachine.Scale;
    }
}
