using System.Net.Sockets;

namespace Engraver.Simulator.Tests;

/// <summary>An internal error of the simulator, at any point: clients do not wait indefinitely, a thread of the pool does not end the process, and the owner is
/// notified.</summary>
public class BreakdownTests
{
    private static readonly FaultPlan AtTheThird = new() { BreakDownAtCommand = 3 };

    [Fact]
    public async Task A_bug_in_a_command_from_the_network_cuts_every_link_and_is_told()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new StoppedTimeProvider(), Faults = AtTheThird });
        var place = await controller.ListenTcpAsync(0, patience.Token);
        await using var memory = controller.OpenConnection();
        using var client = await TcpClientEnd.ConnectAsync(place, patience.Token);
        Assert.Equal("::", await client.AskAsync("x=1;x=2", patience.Token));

        await Assert.ThrowsAsync<SocketException>(() => client.AskAsync("x=3", patience.Token)); // reset, not silent
        var told = await Assert.ThrowsAsync<InvalidOperationException>(() => controller.Broken.WaitAsync(patience.Token));
        Assert.Contains("fault plan", told.InnerException!.Message, StringComparison.Ordinal);
        Assert.Equal(0, await memory.ReadAsync(new byte[8], patience.Token));
    }

    [Fact]
    public async Task A_bug_on_the_thread_of_the_timer_is_told_too()
    {
        var time = new StoppedTimeProvider();
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = time });
        await using var client = controller.OpenConnection();
        Assert.Equal("::", SimulatorRig.Exchange(client, "PRA=20000;BGA\r"));

        time.Bug = new NotSupportedException("the clock broke");
        time.Advance(TimeSpan.FromMilliseconds(50));
        time.Bug = null;

        var told = await Assert.ThrowsAsync<InvalidOperationException>(() => controller.Broken);
        Assert.Equal("the clock broke", told.InnerException!.Message);
        Assert.Equal(0, await client.ReadAsync(new byte[8]));
    }

    [Fact]
    public async Task A_client_in_the_same_process_meets_the_bug_itself()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Faults = AtTheThird });
        rig.Ask("x=1;x=2");

        Assert.Throws<InvalidOperationException>(() => rig.Ask("x=3"));
        Assert.True(rig.Controller.Broken.IsFaulted);
    }

    [Fact]
    public async Task Whoever_waits_for_a_state_of_the_controller_does_not_wait_for_ever()
    {
        using var patience = new CancellationTokenSource(TimeSpan.FromSeconds(20));
        await using var rig = new SimulatorRig(new SimulatorOptions { Faults = AtTheThird });
        var waiting = rig.Controller.WaitUntilAsync(_ => false, patience.Token);
        Assert.Throws<InvalidOperationException>(() => rig.Ask("x=1;x=2;x=3"));

        await Assert.ThrowsAsync<InvalidOperationException>(() => waiting);
    }

    [Fact]
    public async Task Nothing_is_broken_while_all_is_well()
    {
        await using var rig = new SimulatorRig();
        rig.Ask("QQ");

        Assert.False(rig.Controller.Broken.IsCompleted);
    }
}
