using System.Net;
using System.Net.Sockets;

namespace Engraver.Simulator.Tests;

/// <summary>Handles and their failures (galil-dmc.md A.1, I.1, I.15).</summary>
public class LinkTests
{
    private static readonly SimulatorOptions Virtual = new() { Speed = double.PositiveInfinity };

    [Fact]
    public async Task A_host_on_a_socket_talks_to_the_same_controller_and_sees_true_ports()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(30));
        await using var controller = new SimulatedController(Virtual);
        var address = await controller.ListenTcpAsync(0, limit.Token);
        Assert.Equal(IPAddress.Loopback, address.Address);
        using var first = await TcpClientEnd.ConnectAsync(address, limit.Token);
        Assert.Equal("IHA\r\n:", await first.AskAsync("WH", limit.Token));
        using var second = await TcpClientEnd.ConnectAsync(address, limit.Token);
        Assert.Equal("IHB\r\n:", await second.AskAsync("WH", limit.Token));

        var table = await second.AskAsync("TH", limit.Token);

        Assert.Matches("ETHERNET ADDRESS ([0-9A-F]{2}-){5}[0-9A-F]{2}", table);
        Assert.Contains($"IHA TCP PORT {address.Port} TO IP ADDRESS 127,0,0,1 PORT {first.LocalPort}\r\n", table);
        Assert.Contains($"IHB TCP PORT {address.Port} TO IP ADDRESS 127,0,0,1 PORT {second.LocalPort}\r\nIHC AVAILABLE", table);
        Assert.Equal(":", await first.AskAsync("x=5", limit.Token));
        Assert.Equal(" 5.0000\r\n:", await second.AskAsync("MG x", limit.Token));
    }

    [Fact]
    public async Task One_connection_too_many_is_reset()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(30));
        await using var controller = new SimulatedController(Virtual with { HandleCount = 1 });
        var address = await controller.ListenTcpAsync(0, limit.Token);
        using var first = await TcpClientEnd.ConnectAsync(address, limit.Token);
        Assert.Equal(" 0.0000\r\n:", await first.AskAsync("MG _IA2", limit.Token));

        await Assert.ThrowsAsync<SocketException>(async () =>
        {
            using var second = await TcpClientEnd.ConnectAsync(address, limit.Token);
            await second.ReadAsync(limit.Token);
        });

        Assert.Throws<IOException>(controller.OpenConnection);
    }

    [Fact]
    public async Task A_dead_connection_frees_its_handle_and_the_motion_goes_on()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(30));
        await using var controller = new SimulatedController(Virtual);
        var address = await controller.ListenTcpAsync(0, limit.Token);
        using (var host = await TcpClientEnd.ConnectAsync(address, limit.Token))
        {
            Assert.Equal("::", await host.AskAsync("PRA=50000;BGA", limit.Token));
        }

        await controller.WaitUntilAsync(s => s.OpenHandles == 0, limit.Token);
        Assert.True(await controller.WaitUntilIdleAsync(limit.Token));

        using var next = await TcpClientEnd.ConnectAsync(address, limit.Token);
        Assert.Equal("IHA\r\n:", await next.AskAsync("WH", limit.Token));
        Assert.Equal(" 50000\r\n:", await next.AskAsync("TPA", limit.Token));
    }

    [Fact]
    public async Task Dropped_links_end_both_kinds_of_connection_and_leave_the_controller_alive()
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(30));
        await using var controller = new SimulatedController(Virtual);
        var address = await controller.ListenTcpAsync(0, limit.Token);
        using var host = await TcpClientEnd.ConnectAsync(address, limit.Token);
        Assert.Equal(":", await host.AskAsync("x=7", limit.Token));
        using var memory = controller.OpenConnection();

        controller.DropConnections();

        await Assert.ThrowsAsync<SocketException>(() => host.ReadAsync(limit.Token));
        Assert.Equal(0, await memory.ReadAsync(new byte[1], limit.Token));
        Assert.Throws<IOException>(() => memory.Write([13]));
        using var again = controller.OpenConnection();
        Assert.Equal(" 7.0000\r\n:", SimulatorRig.Exchange(again, "MG x\r"));
    }

    [Fact]
    public async Task IHT_closes_the_others_and_IHS_the_sender_behind_its_prompt()
    {
        await using var rig = new SimulatorRig();
        using var other = rig.Controller.OpenConnection();

        Assert.Equal(":", rig.Ask("IHT=>-3"));
        Assert.Throws<IOException>(() => other.Write([13]));
        Assert.Equal((7, 1), (rig.Value("_IA2"), rig.Value("_IA4")));
        Assert.Equal(":", rig.Ask("IHS=>-3"));
        Assert.Throws<IOException>(() => rig.Stream.Write([13]));
        Assert.Equal(0, rig.Controller.Status.OpenHandles);
    }

    [Fact]
    public async Task Planned_refusals_and_drops_happen_at_their_command()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions
        {
            Faults = new FaultPlan { Refusals = [new CommandRefusal(2, 32)], Drops = [new HandleDrop(0, 4)] },
        });

        Assert.Equal(":", rig.Ask("x=1"));
        Assert.Equal("?", rig.Ask("x=2"));
        Assert.Equal(" 32\r\n:", rig.Ask("TC"));
        Assert.Equal(":", rig.Ask(""));
        Assert.Throws<IOException>(() => rig.Ask(""));
    }

    [Fact]
    public void A_fault_plan_is_read_from_its_file()
    {
        var plan = FaultPlan.Parse("""{"refusals":[{"command":12,"tcCode":32}],"drops":[{"handle":0,"afterCommands":40}],"freezeAfterCommands":99,"replyDelay":"00:00:00.050"}""");

        Assert.Equal([new CommandRefusal(12, 32)], plan.Refusals);
        Assert.Equal([new HandleDrop(0, 40)], plan.Drops);
        Assert.Equal((99, 50), (plan.FreezeAfterCommands, plan.ReplyDelay.TotalMilliseconds));
        Assert.Throws<System.Text.Json.JsonException>(() => FaultPlan.Parse("""{"refusal":[]}"""));
    }

    [Fact]
    public async Task A_frozen_controller_answers_nothing_while_its_motion_goes_on()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Faults = new FaultPlan { FreezeAfterCommands = 2 } });
        rig.Do("PRA=5000", "BGA");

        Assert.Equal("", rig.Ask("TP"));
        Assert.Equal("", rig.Ask("STA"));
        rig.RunToIdle();
        Assert.Equal(5000, rig.Controller.Record.Snapshot()[^1].A);
    }

    [Fact]
    public async Task Late_replies_come_after_their_delay()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Faults = new FaultPlan { ReplyDelay = TimeSpan.FromMilliseconds(50) } });

        Assert.Equal("", rig.Ask("x=1"));
        rig.Time.Advance(TimeSpan.FromMilliseconds(45));
        Assert.Equal("", SimulatorRig.ReadAvailable(rig.Stream));
        rig.Time.Advance(TimeSpan.FromMilliseconds(10));
        Assert.Equal(":", SimulatorRig.ReadAvailable(rig.Stream));
    }
}
