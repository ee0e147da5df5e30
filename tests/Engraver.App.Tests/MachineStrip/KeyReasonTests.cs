using Avalonia;
using Avalonia.Controls;
using Engraver.App.MachineStrip;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.MachineStrip;

/// <summary>A disabled key of the strip shows its reason, on itself and in its tip.</summary>
[Collection(DesktopCollection.Name)]
public sealed class KeyReasonTests(DesktopFixture fixture)
{
    [Fact]
    public Task ARM_and_START_say_why_they_do_not_work_as_the_machine_goes_through_its_states() => fixture.WithOperator(here =>
    {
        AssertReason(here, "ArmKey", "no controller", "No controller is connected");
        AssertReason(here, "StartKey", "no controller", "No controller is connected");
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address);
        here.WaitUntilIdle();
        AssertReason(here, "ArmKey", null, "Checks the job");
        AssertReason(here, "StartKey", "ARM first", "Press ARM first");
        here.Enter("CNCARM", "Stream");
        AssertReason(here, "ArmKey", "armed", "The job is armed");
        AssertReason(here, "StartKey", null, "Starts the armed job");
        AssertReason(here, "HoldKey", null, "HOLD works only while a job is running");
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine is { Status.State: MachineState.Running, Runs.Progress.SegmentsSent: > 0 });
        here.Step();
        AssertReason(here, "ArmKey", "job running", "A job is running");
        AssertReason(here, "StartKey", "job running", "A job is running");
        here.Hands.Press(Avalonia.Input.Key.Pause);
        here.Until(() => here.Commands.Machine.Runs.LastRun is not null);
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
    });

    [Fact]
    public Task The_reason_fits_on_the_key() => fixture.WithOperator(here =>
    {
        var why = here.Find<TextBlock>("StartWhyText");
        var key = here.Find<Button>("StartKey");
        var corner = why.TranslatePoint(new Point(why.Bounds.Width, why.Bounds.Height), key)!.Value;

        Assert.InRange(corner.X, 0, key.Bounds.Width);
        Assert.InRange(corner.Y, 0, key.Bounds.Height);
        Assert.DoesNotContain(why.TextLayout.TextLines, line => line.HasOverflowed || line.HasCollapsed);
    });

    [Fact]
    public Task Every_state_of_the_machine_has_its_reason_in_words() => fixture.WithOperator(_ =>
    {
        foreach (var state in Enum.GetValues<MachineState>())
        {
            var status = MachineStatus.Offline with { State = state };
            foreach (var reason in new[] { KeyReasons.Arm(status), KeyReasons.Start(status), KeyReasons.Hold(status) })
            {
                Assert.True(reason is null || KeyReasons.ShortOf(reason).Length is > 0 and <= 13, $"{state}: {reason}");
                Assert.EndsWith(".", KeyReasons.TipOf(reason ?? "NoJob", "Machine.StopTip", status), StringComparison.Ordinal);
            }
        }
    });

    /// <param name="why">The text on the key; null: none.</param>
    private static void AssertReason(Operator here, string key, string? why, string tip)
    {
        here.Step();
        var button = here.Find<Button>(key);
        Assert.StartsWith(tip, (string)ToolTip.GetTip(button)!, StringComparison.Ordinal);
        Assert.True(ToolTip.GetShowOnDisabled(button));
        if (key == "HoldKey") return;
        Assert.Equal(why is null, button.IsEffectivelyEnabled);
        var text = here.Find<TextBlock>(key.Replace("Key", "WhyText", StringComparison.Ordinal));
        Assert.Equal((why ?? "", why is not null), (text.Text, text.IsEffectivelyVisible));
    }
}
