using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Safety;

/// <summary>STOP between START and the first segment.</summary>
[Collection(DesktopCollection.Name)]
public sealed class EarlyStopTests(DesktopFixture fixture)
{
    [Fact]
    public Task A_job_that_has_not_yet_moved_ends_and_it_is_said() => fixture.WithOperator(here =>
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Avalonia.Input.Key.Enter);
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running);
        here.Hands.Press(Avalonia.Input.Key.Pause);
        here.Until(() => !here.Commands.Machine.IsRunning);
        here.WaitUntilIdle();

        Assert.Equal(MachineState.Ready, here.Commands.Machine.Status.State);
        if (here.Commands.Machine.Runs.LastRun is { } run) Assert.Equal(JobOutcome.Stopped, run.Result.Outcome); // the first segment was faster
        else Assert.Contains(here.History, line => line.Contains("stopped before any axis moved", StringComparison.Ordinal));
    });
}
